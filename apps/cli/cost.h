#pragma once

#include "relief/session/build_relief.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Returns the memory that this process can still get, within its limit of address space, in MB of
/// 2^20 bytes.
double free_mb();

/// Estimates the minimum memory of a build with the given number of vertices, MB.
double least_mb(double vertices);

/// Prints a note, if a build will take long. Fails with `limit` if there is
/// certainly too little memory. Does not check meshes that are specified by their edge length.
Status check_cost(const relief::ReliefOptions& options);

}  // namespace relievo::cli
