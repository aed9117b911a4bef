#!/bin/sh
# One share of a batch as a task of a Slurm job array, on as many processors and as much memory as
# the task was given. What is passed to it is what `relievo batch` takes:
#   sbatch --array=1-20 --cpus-per-task=4 --mem=4G relievo-array.sh drawings -o models
# and when all have ended: relievo batch --merge -o models
# RELIEVO names the program where it is not on the path.
set -eu

first="${SLURM_ARRAY_TASK_MIN:-1}"
share=$((${SLURM_ARRAY_TASK_ID:?is not set: start this with sbatch --array} - first + 1))
memory="${SLURM_MEM_PER_NODE:-}"
[ -n "$memory" ] || memory=$((${SLURM_MEM_PER_CPU:-0} * ${SLURM_CPUS_PER_TASK:-1}))
[ "$memory" -lt 200 ] || set -- "$@" --memory "$memory"
exec "${RELIEVO:-relievo}" batch "$@" --jobs "${SLURM_CPUS_PER_TASK:-1}" \
  --shard "$share/${SLURM_ARRAY_TASK_COUNT:-1}"
