#pragma once

#include "relief/session/build_relief.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Memory that is free or can be made so within this process's own limit of address space, MB of
/// 2^20 bytes.
double free_mb();

/// The least that a build of so many vertices takes, MB.
double least_mb(double vertices);

/// Tells, unless `quiet`, that a build will take long, and refuses with `limit` one for which there
/// certainly is too little memory. Says nothing of meshes that are asked for by their edge length.
Status check_cost(const relief::ReliefOptions& options, bool quiet);

}  // namespace relievo::cli
