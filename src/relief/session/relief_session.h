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

/// Remembers the inputs that the value of a stage was computed from.
class StageState {
 public:
  /// Calls `compute` unless the value was computed from the same inputs.
  template <class Compute>
  Status refresh(Key inputs, const Compute& compute) {
    if (inputs_ && *inputs_ == inputs) return Done{};
    inputs_.reset();
    if (Status status = compute(); !status) return status;
    inputs_ = std::move(inputs);
    ++version_;
    return Done{};
  }

  /// Marks the value as gone.
  void forget() { inputs_.reset(); }

  /// Returns a number that grows with every computation. It is in the keys of later stages.
  uint64_t version() const { return version_; }

 private:
  std::optional<Key> inputs_;
  uint64_t version_ = 0;
};

/// The relief of a scene that is being edited. Keeps triangulation, matrices, factors and active
/// sets, and computes only what depends on a change:
///
/// - c, d, a bulge: a solve of the inflation, and of the order from its active set;
/// - lean, a slope, the angle of a crease: the same solve of the order alone;
/// - alpha0, rho: as c, and the part of the inflation's factor where they act;
/// - a relation: the constraints and the order, with a new pattern if other nodes are linked;
/// - an outline, a join, the line of a crease, the order of parts, the resolution: everything.
///
/// The first solve starts from the contacts on a coarser mesh, and so does the non-linear
/// iteration. A warm solve has the minimum of a cold one: the same active set, and heights that
/// differ by round-off, or by the tolerance of the non-linear method. Takes about 3 kB per node.
class ReliefSession {
 public:
  enum class Use {
    many,   ///< several updates
    one,    ///< one update, with less memory
    guess,  ///< one update, without a start from a coarser mesh
  };

  explicit ReliefSession(Use use = Use::many) : use_(use) {}

  /// Brings the relief up to date. Fails as the stages do. After a failure relief() must not be
  /// used until an update succeeds, which keeps the values that are still right.
  Status update(const Scene& scene, const ReliefOptions& options, const RunContext& context = {});

  /// Returns the relief of the last update. Its times are of the stages that ran.
  const Relief& relief() const { return relief_; }

  /// Returns the contacts of the last solution by the approximate method.
  const std::vector<DepthContact>& contacts() const { return ordering_system_.contacts; }

  /// Returns the end of the last solution by the non-linear method.
  const NonlinearMemory& nonlinear_memory() const { return nonlinear_memory_; }

  /// Moves the relief out; the session must not be used afterwards.
  Relief take() &&;

 private:
  class Request;

  Status update_surface(Request& request);
  Status update_layers(Request& request);
  Status update_discretisation(Request& request);
  Status update_inflation(Request& request);
  Status update_ordering(Request& request);
  Status update_nonlinear(Request& request);
  Status update_hidden(Request& request);
  void renumber_contacts(const Scene& scene);

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
  std::vector<std::string> part_ids_;  ///< ids of the parts that contacts and marks name
  Relief relief_;
};

}  // namespace relievo::relief
