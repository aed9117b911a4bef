#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "relief/hiding/hide_sheets.h"
#include "relief/session/build_relief.h"
#include "relief/session/stage_keys.h"

namespace relievo::relief {

/// Whether the value of a stage is that of its present inputs.
class StageState {
 public:
  /// Calls `compute` unless the last one that succeeded had the same inputs.
  template <class Compute>
  Status refresh(Key inputs, const Compute& compute) {
    if (inputs_ && *inputs_ == inputs) return Done{};
    inputs_.reset();
    if (Status status = compute(); !status) return status;
    inputs_ = std::move(inputs);
    ++version_;
    return Done{};
  }

  /// The value is gone.
  void forget() { inputs_.reset(); }

  /// Grows with every computation: what later stages name as their input.
  uint64_t version() const { return version_; }

 private:
  std::optional<Key> inputs_;
  uint64_t version_ = 0;
};

/// The relief of a scene that is being edited. Keeps triangulation, matrices, factors and active
/// sets, and computes again only what depends on what has changed:
///
/// - c, d, a bulge: a solve of the inflation, and of the order from its active set;
/// - lean, a slope, the angle of a crease: the solve of the order alone, likewise;
/// - alpha0, rho: besides, the factor of the inflation where they act;
/// - a relation: the constraints, and the order, with a new pattern where other nodes are linked;
/// - an outline, a join, the line of a crease, the order of parts, the resolution: everything.
///
/// Where nothing is known of the order yet, it begins from that of a coarser mesh, and so does the
/// iteration of the non-linear method. The minimum of a warm solve is the one of a cold solve: the
/// same active set, and heights that differ by round-off at most, or, of the non-linear method, by
/// its tolerance. Takes some 3 kB per node.
class ReliefSession {
 public:
  enum class Use {
    many,   ///< several updates
    one,    ///< a single one, with less memory
    guess,  ///< the same, on a mesh too coarse to begin from a coarser one
  };

  explicit ReliefSession(Use use = Use::many) : use_(use) {}

  /// Brings the relief up to date. Fails as the stages do; then relief() is not to be used until an
  /// update succeeds, which goes on with what is still right.
  Status update(const Scene& scene, const ReliefOptions& options, const RunContext& context = {});

  /// Of the last update. Its times are of the stages that were computed again.
  const Relief& relief() const { return relief_; }

  /// Where parts touch in the relief, or may: of the approximate method.
  const std::vector<DepthContact>& contacts() const { return ordering_system_.contacts; }

  /// Where the non-linear method ended.
  const NonlinearMemory& nonlinear_memory() const { return nonlinear_memory_; }

  /// The relief itself; the session is empty afterwards.
  Relief take() &&;

 private:
  struct Request;

  Status update_surface(const Request& request);
  Status update_layers(const Request& request);
  Status update_discretisation(const Request& request);
  Status update_inflation(const Request& request);
  Status update_ordering(const Request& request);
  Status update_nonlinear(const Request& request);
  Status update_hidden(const Request& request);
  void begin_like(const Scene& scene);

  Use use_;
  StageState sheets_state_;
  StageState layers_state_;
  StageState discretisation_state_;
  StageState poisson_state_;
  StageState inflation_state_;
  StageState heights_state_;
  StageState hidden_state_;
  JoinedSheets sheets_;
  Discretisation discretisation_;
  std::optional<PoissonSystem> poisson_;
  Inflation inflation_;
  OrderingSystem ordering_system_;
  std::optional<FlapSystem> flaps_;  ///< of the discretisation
  NonlinearMemory nonlinear_memory_;
  std::vector<std::string> part_ids_;  ///< that the contacts' and marks' parts had
  Relief relief_;
};

}  // namespace relievo::relief
