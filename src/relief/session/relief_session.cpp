#include "relief/session/relief_session.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/stopwatch.h"
#include "kernel/base/workers.h"
#include "kernel/geometry/nearest_mark.h"
#include "relief/discretisation/discretisation.h"

namespace relievo::relief {

/// The inputs of an update and its wall times. The time of a stage is without its pieces.
class ReliefSession::Request {
 public:
  Request(const Scene& a_scene, const ReliefOptions& all_options, const RunContext& watched)
      : scene(a_scene), options(all_options), context(watched) {
    context.timed = [this](const char* piece, double milliseconds) {
      times.push_back({piece, milliseconds, false});
      pieces_ += milliseconds;
    };
  }
  Request(const Request&) = delete;
  Request& operator=(const Request&) = delete;

  /// Returns a context for work on another thread. take_beside() adds its pieces when it has ended.
  RunContext context_beside() {
    RunContext beside = context;
    beside.progress = {};
    beside.timed = [this](const char* piece, double milliseconds) {
      beside_.push_back({piece, milliseconds, true});
    };
    return beside;
  }

  void take_beside() { times.insert(times.end(), beside_.begin(), beside_.end()); }

  void finish(const char* stage) {
    times.push_back({stage, watch_.lap() - pieces_, false});
    pieces_ = 0;
  }

  const Scene& scene;
  const ReliefOptions& options;
  RunContext context;
  std::vector<StageTime> times;

 private:
  std::vector<StageTime> beside_;
  Stopwatch watch_;
  double pieces_ = 0;
};

namespace {

/// Number of nodes of a mesh relative to the coarser one that the first solve starts from.
constexpr int coarsening = 8;
/// A coarser mesh of fewer nodes is not worth the effort.
constexpr int smallest_coarse_mesh = 500;
/// Least tolerance of the non-linear method on the coarser mesh.
constexpr double coarse_tolerance = 1e-4;

/// Solves on a coarser mesh. Leaves both results empty if that has no solution.
void find_guess(const Scene& scene, ReliefOptions options, const RunContext& context,
                std::vector<DepthContact>& contacts, NonlinearMemory& memory) {
  LayerOptions& layers = options.layers;
  layers.edge_length *= std::sqrt(static_cast<double>(coarsening));
  layers.vertex_budget /= coarsening;
  if (layers.edge_length == 0 && layers.vertex_budget < smallest_coarse_mesh) return;
  options.nonlinear.snapshots.clear();
  options.nonlinear.tolerance = std::max(options.nonlinear.tolerance, coarse_tolerance);
  ReliefSession session(ReliefSession::Use::guess);
  if (!session.update(scene, options, RunContext{context.cancel, {}, {}, {}})) return;
  contacts = session.contacts();
  memory = session.nonlinear_memory();
}

}  // namespace

Status ReliefSession::update(const Scene& scene, const ReliefOptions& options,
                             const RunContext& context) {
  if (Status status = validate(scene); !status) return status;
  relief_.times.clear();
  Request request(scene, options, context);
  const bool guess = use_ != Use::guess && sheets_state_.version() == 0;
  Status status = Done{};
  std::vector<DepthContact> contacts;
  NonlinearMemory memory;
  run_tasks(guess ? 2 : 1, [&](int task) {
    if (task == 0)
      status = update_surface(request);
    else
      find_guess(scene, options, context, contacts, memory);
  });
  if (!status) return status;
  if (guess) {
    ordering_system_.contacts = std::move(contacts);
    nonlinear_memory_ = std::move(memory);
  }
  status =
      options.method == Method::nonlinear ? update_nonlinear(request) : update_ordering(request);
  if (!status) return status;
  if (status = update_hidden(request); !status) return status;
  relief_.times = std::move(request.times);
  return Done{};
}

Relief ReliefSession::take() && { return std::move(relief_); }

Status ReliefSession::update_surface(Request& request) {
  if (Status status = update_layers(request); !status) return status;
  if (Status status = update_discretisation(request); !status) return status;
  const RunContext beside = request.context_beside();
  Status status = Done{};
  run_tasks(2, [&](int task) {
    if (task == 0)
      status = update_inflation(request);
    else
      prepare_ordering({relief_.layers, discretisation_, request.scene}, request.options.ordering,
                       ordering_system_, beside);
  });
  request.take_beside();
  return status;
}

/// Clears the systems for a new mesh, and gives the parts of contacts and marks their new numbers,
/// so that the order starts from them.
void ReliefSession::renumber_contacts(const Scene& scene) {
  std::vector<DepthContact> contacts = std::move(ordering_system_.contacts);
  ordering_system_ = {};
  flaps_.reset();
  const auto renumber = [&](int& part) {
    const auto same = [&](const Part& other) { return other.id == part_ids_[part]; };
    const auto found = std::find_if(scene.parts.begin(), scene.parts.end(), same);
    part = found == scene.parts.end() ? -1 : static_cast<int>(found - scene.parts.begin());
  };
  for (std::vector<DepthContact>* list : {&contacts, &nonlinear_memory_.contacts})
    for (DepthContact& contact : *list) {
      renumber(contact.lower);
      renumber(contact.upper);
    }
  for (NonlinearMark& mark : nonlinear_memory_.marks) renumber(mark.part);
  sort_marks(nonlinear_memory_.marks);
  ordering_system_.contacts = std::move(contacts);
  part_ids_.clear();
  for (const Part& part : scene.parts) part_ids_.push_back(part.id);
}

Status ReliefSession::update_layers(Request& request) {
  const Scene& scene = request.scene;
  const LayerOptions& options = request.options.layers;
  Status status = sheets_state_.refresh(sheets_key(scene, options), [&]() -> Status {
    auto sheets = join_sheets(scene, options, request.context);
    if (!sheets) return sheets.error();
    sheets_ = std::move(*sheets);
    request.finish("mesh");
    return Done{};
  });
  if (!status) return status;
  Key key = layers_key(scene, options);
  status = layers_state_.refresh(key.add(sheets_state_.version()), [&]() -> Status {
    auto layers = constrain_sheets(sheets_, scene, options);
    if (!layers) return layers.error();
    relief_.layers = std::move(*layers);
    request.finish("mesh");
    return Done{};
  });
  if (use_ != Use::many) {
    sheets_state_.forget();
    sheets_ = {};
  }
  return status;
}

Status ReliefSession::update_discretisation(Request& request) {
  // Relations "below" change the order of faces, in which sums run.
  const LayeredMesh& mesh = relief_.layers;
  Key key = Key().add(sheets_state_.version(), mesh.face_part, mesh.face_flap);
  return discretisation_state_.refresh(std::move(key), [&]() -> Status {
    discretisation_ = discretise(mesh, request.context);
    if (request.context.cancelled()) return interrupted_error();
    renumber_contacts(request.scene);
    return Done{};
  });
}

Status ReliefSession::update_inflation(Request& request) {
  const InflationOptions& options = request.options.inflation;
  const RunContext& context = request.context;
  const LayeredMesh& mesh = relief_.layers;
  Key roles = Key().add(discretisation_state_.version(), mesh.node_role);
  for (const RampNode& node : mesh.ramp_nodes) roles.add(node.node, node.below);
  Status status = poisson_state_.refresh(std::move(roles), [&]() -> Status {
    poisson_.emplace(mesh, discretisation_,
                     use_ == Use::many ? Refactorisation::incremental : Refactorisation::complete,
                     context);
    if (context.cancelled()) return interrupted_error();
    return Done{};
  });
  if (!status) return status;
  Key key = inflation_key(request.scene, options);
  key.add(poisson_state_.version(), boundary_key(mesh));
  status = inflation_state_.refresh(std::move(key), [&]() -> Status {
    auto inflation = inflate({mesh, discretisation_, request.scene}, options, *poisson_, context);
    if (!inflation) return inflation.error();
    inflation_ = std::move(*inflation);
    request.finish("inflate");
    return Done{};
  });
  if (use_ != Use::many) {
    poisson_state_.forget();
    poisson_.reset();
  }
  return status;
}

Status ReliefSession::update_ordering(Request& request) {
  const OrderingOptions& options = request.options.ordering;
  const SurfaceInput surface{relief_.layers, discretisation_, request.scene};
  Key key = ordering_key(relief_.layers, request.scene, options);
  key.add(Method::approximate, inflation_state_.version());
  return heights_state_.refresh(std::move(key), [&]() -> Status {
    auto ordering = order_depth(surface, inflation_, options, ordering_system_, request.context);
    if (!ordering) return ordering.error();
    relief_.inflation = inflation_;
    relief_.ordering = std::move(*ordering);
    relief_.nonlinear = {};
    relief_.snapshots.clear();
    request.finish("order");
    return Done{};
  });
}

/// Hides in place: visible sheets do not change, and once hidden, sheets stay so in models of the
/// visible surface alone.
Status ReliefSession::update_hidden(Request& request) {
  if (!request.options.hidden) return Done{};
  return hidden_state_.refresh(Key().add(heights_state_.version()), [&]() -> Status {
    Inflation inflation = relief_.inflation;
    Ordering ordering = relief_.ordering;
    hide_sheets({relief_.layers, discretisation_, request.scene}, flaps_, inflation, ordering,
                request.context);
    if (use_ != Use::many) flaps_.reset();
    if (request.context.cancelled()) return interrupted_error();
    relief_.inflation = std::move(inflation);
    relief_.ordering = std::move(ordering);
    request.finish("hide");
    return Done{};
  });
}

Status ReliefSession::update_nonlinear(Request& request) {
  const SurfaceInput surface{relief_.layers, discretisation_, request.scene};
  NonlinearOptions options = request.options.nonlinear;
  options.ordering = request.options.ordering;
  options.bumps = request.options.inflation;
  Key key = ordering_key(relief_.layers, request.scene, options.ordering);
  key.add(Method::nonlinear, inflation_state_.version(), nonlinear_key(options));
  return heights_state_.refresh(std::move(key), [&]() -> Status {
    auto solution = solve_nonlinear(surface, inflation_, options, nonlinear_memory_,
                                    ordering_system_, request.context);
    if (!solution) return solution.error();
    nonlinear_memory_ = std::move(solution->memory);
    relief_.inflation = std::move(solution->inflation);
    relief_.ordering = std::move(solution->ordering);
    relief_.nonlinear = std::move(solution->report);
    relief_.snapshots = std::move(solution->snapshots);
    request.finish("nonlinear");
    return Done{};
  });
}

}  // namespace relievo::relief
