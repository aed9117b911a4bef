#include "support/depth_optimality.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "kernel/base/disjoint_sets.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::testing {
namespace {

/// Nodes held together by touching pairs, and the pairs as bits: `needs[i]` are the nodes that
/// any upward closed subset with node i contains too.
struct Cluster {
  std::vector<int> nodes;
  std::vector<uint32_t> needs;
};

std::vector<Cluster> touching_clusters(int node_count, const std::vector<relief::DepthPair>& pairs,
                                       const std::vector<double>& h) {
  DisjointSets sets(node_count);
  std::vector<relief::DepthPair> touching;
  for (const relief::DepthPair& pair : pairs)
    if (h[pair.lower] >= h[pair.upper]) {
      touching.push_back(pair);
      sets.unite(pair.lower, pair.upper);
    }
  std::vector<int> place(static_cast<size_t>(node_count));
  std::map<int, Cluster> clusters;
  for (int n = 0; n < node_count; ++n) {
    Cluster& cluster = clusters[sets.find(n)];
    place[n] = static_cast<int>(cluster.nodes.size());
    cluster.nodes.push_back(n);
    cluster.needs.push_back(0);
  }
  for (const relief::DepthPair& pair : touching) {
    Cluster& cluster = clusters[sets.find(pair.lower)];
    cluster.needs[place[pair.lower]] |= 1u << place[pair.upper];
    if (pair.equal) cluster.needs[place[pair.upper]] |= 1u << place[pair.lower];
  }
  std::vector<Cluster> result;
  for (auto& [first, cluster] : clusters) result.push_back(std::move(cluster));
  return result;
}

double imbalance_of(const Cluster& cluster, const Eigen::VectorXd& force) {
  const int size = static_cast<int>(cluster.nodes.size());
  double worst = 0;
  for (uint32_t subset = 1; subset < 1u << size; ++subset) {
    double sum = 0;
    bool closed = true;
    for (int i = 0; i < size && closed; ++i) {
      if ((subset >> i & 1u) == 0) continue;
      closed = (cluster.needs[i] & ~subset) == 0;
      sum += force[cluster.nodes[i]];
    }
    if (!closed) continue;
    const bool whole = subset + 1 == 1u << size;
    worst = std::max(worst, whole ? std::abs(sum) : -sum);
  }
  return worst;
}

}  // namespace

DepthOptimality check_depth_optimality(const ShiftCost& cost, const relief::Inflation& inflation,
                                       const std::vector<relief::DepthPair>& pairs,
                                       const std::vector<double>& h) {
  const double scale = relief::scene_scale(cost.mesh);
  Eigen::VectorXd g(static_cast<Eigen::Index>(h.size()));
  for (size_t n = 0; n < h.size(); ++n) {
    const double u = inflation.u[n];
    g[static_cast<Eigen::Index>(n)] = scale * (h[n] - std::copysign(std::sqrt(std::abs(u)), u));
  }
  const Eigen::VectorXd force = cost.slope(g);
  DepthOptimality result;
  for (const relief::DepthPair& pair : pairs) {
    const double violation = scale * (h[pair.lower] - h[pair.upper]);
    result.violation = std::max(result.violation, pair.equal ? std::abs(violation) : violation);
  }
  for (const Cluster& cluster : touching_clusters(static_cast<int>(h.size()), pairs, h))
    result.imbalance = std::max(result.imbalance, imbalance_of(cluster, force));
  return result;
}

}  // namespace relievo::testing
