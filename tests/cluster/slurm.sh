#!/bin/sh
# A job array of twenty tasks on a Slurm cluster of this machine alone, with a key, ports and folders
# of its own: the shares of a batch, killed and begun again in the middle, give the same files as one
# batch. Needs root, slurmctld, slurmd and munge. Usage: slurm.sh PROGRAM [DRAWINGS]   (40)
set -eu
program=$(realpath "${1:?the program is not given}")
count="${2:-40}"
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d /tmp/relievo-slurm-XXXXXX)
user=$(id -un)
host=$(hostname -s)
pids=""

leave() {
  code=$?
  for pid in $pids; do kill "$pid" 2> /dev/null || true; done
  [ $code -eq 0 ] || tail -n 20 "$work"/*.log >&2 || true
  rm -rf "$work"
  exit $code
}
trap leave EXIT INT TERM

begin_cluster() {
  mkdir -p "$work/munge" "$work/state" "$work/spool"
  chmod 755 "$work"
  dd if=/dev/urandom of="$work/munge/key" bs=1024 count=1 2> /dev/null
  chmod 700 "$work/munge"
  chmod 400 "$work/munge/key"
  munged --force --foreground --socket="$work/munge.socket" --key-file="$work/munge/key" \
    --pid-file="$work/munge/pid" --log-file="$work/munge.log" --seed-file="$work/munge/seed" \
    2> /dev/null &
  pids="$pids $!"
  cat > "$work/slurm.conf" << CONF
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
CommunicationParameters=NoInAddrAny
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
SlurmUser=$user
SlurmdUser=$user
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_interval=5
ReturnToService=2
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
  export SLURM_CONF="$work/slurm.conf"
  slurmctld -D > /dev/null 2>&1 &
  pids="$! $pids"
  slurmd -D -N "$host" > /dev/null 2>&1 &
  pids="$! $pids"
  for _ in $(seq 60); do
    if sinfo -h -o %T 2> /dev/null | grep -q idle; then return; fi
    sleep 1
  done
  echo "The cluster did not come up." >&2
  exit 1
}

# Starts the array and prints its number.
submit() {
  sbatch --parsable --array=1-20 --chdir="$work" --output="$work/task-%a.log" \
    --export=ALL,RELIEVO="$program" "$root/scripts/cluster/relievo-array.sh" "$@"
}

# Waits until the array has no tasks left.
wait_for() {
  while [ -n "$(squeue -h -j "$1" 2> /dev/null)" ]; do sleep 1; done
}

mkdir "$work/drawings"
for k in $(seq "$count"); do
  sed "s/<svg /<svg data-copy=\"$k\" /" "$root/examples/lamb.svg" > "$work/drawings/$k.svg"
done
begin_cluster
cd "$work"
set -- drawings --vertices 2000 --make glb,normal --map-size 200
"$program" batch "$@" -q -o one
job=$(submit "$@" -o many)
while [ "$(cat many/journal-*.jsonl 2> /dev/null | wc -l)" -lt $((count / 4)) ]; do sleep 0.2; done
scancel --signal=KILL --full "$job" 2> /dev/null || true
scancel "$job" 2> /dev/null || true
wait_for "$job"
before=$(cat many/journal-*.jsonl | wc -l)
wait_for "$(submit "$@" -o many)"
"$program" batch --merge -o many
diff -r -x 'journal*' one many
[ "$(wc -l < many/journal.jsonl)" -eq "$count" ]
echo "slurm: $count drawings in 20 tasks, killed after $before and begun again: the same files"
