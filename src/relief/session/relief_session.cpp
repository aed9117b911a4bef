#include "relief/session/relief_session.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "kernel/base/workers.h"
#include "kernel/geometry/nearest_mark.h"
#include "relief/discretisation/discretisation.h"

namespace relievo::relief {

/// Fills a list of wall times. The time of a stage is without the pieces that it reported.
class StageClock {
 public:
  explicit StageClock(std::vector<StageTime>& times) : times_(times) {}

  /// `context` with the pieces' times going to the list.
  RunContext listen(RunContext context) {
    context.timed = [this](const char* piece, double milliseconds) {
      times_.push_back({piece, milliseconds, false});
      pieces_ += milliseconds;
    };
    return context;
  }

  /// The same for work on another thread; take_beside() adds its pieces when it has ended.
  RunContext listen_beside(RunContext context) {
    context.progress = {};
    context.timed = [this](const char* piece, double milliseconds) {
      beside_.push_back({piece, milliseconds, true});
    };
    return context;
  }

  void take_beside() {
    times_.insert(times_.end(), beside_.begin(), beside_.end());
    beside_.clear();
  }

  void finish(const char* stage) {
    const auto now = Clock::now();
    const std::chrono::duration<double, std::milli> elapsed = now - last_;
    times_.push_back({stage, elapsed.count() - pieces_, false});
    last_ = now;
    pieces_ = 0;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<StageTime>& times_;
  std::vector<StageTime> beside_;
  Clock::time_point last_ = Clock::now();
  double pieces_ = 0;
};

/// What an update was asked for.
struct ReliefSession::Request {
  const Scene& scene;
  const ReliefOptions& options;
  const RunContext& context;
  StageClock& clock;
};

namespace {

/// The mesh that a first guess is found on has so many times fewer nodes.
constexpr int coarsening = 8;
/// It is not worth the trouble where it would have fewer than so many.
constexpr int smallest_coarse_mesh = 500;
/// Of the non-linear method on that mesh.
constexpr double coarse_tolerance = 1e-4;

/// What the solution on a coarser mesh tells of the one that is wanted.
struct Guess {
  std::vector<DepthContact> contacts;
  NonlinearMemory nonlinear;
};

/// Nothing where the coarse problem has no solution.
Guess coarse_guess(const Scene& scene, ReliefOptions options, const RunContext& context) {
  LayerOptions& layers = options.layers;
  layers.edge_length *= std::sqrt(static_cast<double>(coarsening));
  layers.vertex_budget /= coarsening;
  if (layers.edge_length == 0 && layers.vertex_budget < smallest_coarse_mesh) return {};
  options.nonlinear.snapshots.clear();
  options.nonlinear.tolerance = std::max(options.nonlinear.tolerance, coarse_tolerance);
  ReliefSession session(ReliefSession::Use::guess);
  if (!session.update(scene, options, RunContext{context.cancel, {}, {}, {}})) return {};
  return {session.contacts(), session.nonlinear_memory()};
}

}  // namespace

Status ReliefSession::update(const Scene& scene, const ReliefOptions& options,
                             const RunContext& context) {
  if (Status status = validate(scene); !status) return status;
  relief_.times.clear();
  std::vector<StageTime> times;
  StageClock clock(times);
  const RunContext timed = clock.listen(context);
  const Request request{scene, options, timed, clock};
  const bool nonlinear = options.method == Method::nonlinear;
  const bool guess = use_ != Use::guess && sheets_state_.version() == 0;
  Status status = Done{};
  Guess coarse;
  run_tasks(guess ? 2 : 1, [&](int task) {
    if (task == 0)
      status = update_surface(request);
    else
      coarse = coarse_guess(scene, options, context);
  });
  if (!status) return status;
  if (guess) {
    ordering_system_.contacts = std::move(coarse.contacts);
    nonlinear_memory_ = std::move(coarse.nonlinear);
  }
  status = nonlinear ? update_nonlinear(request) : update_ordering(request);
  if (!status) return status;
  if (status = update_hidden(request); !status) return status;
  relief_.times = std::move(times);
  return Done{};
}

Relief ReliefSession::take() && { return std::move(relief_); }

Status ReliefSession::update_surface(const Request& request) {
  if (Status status = update_layers(request); !status) return status;
  if (Status status = update_discretisation(request); !status) return status;
  const RunContext beside = request.clock.listen_beside(request.context);
  Status status = Done{};
  run_tasks(2, [&](int task) {
    if (task == 0)
      status = update_inflation(request);
    else
      prepare_ordering({relief_.layers, discretisation_, request.scene}, request.options.ordering,
                       ordering_system_, beside);
  });
  request.clock.take_beside();
  return status;
}

/// A new mesh: the order begins from what touched on the last one.
void ReliefSession::begin_like(const Scene& scene) {
  std::vector<DepthContact> contacts = std::move(ordering_system_.contacts);
  ordering_system_ = {};
  flaps_.reset();
  const auto number = [&](int& part) {
    const auto same = [&](const Part& other) { return other.id == part_ids_[part]; };
    const auto found = std::find_if(scene.parts.begin(), scene.parts.end(), same);
    part = found == scene.parts.end() ? -1 : static_cast<int>(found - scene.parts.begin());
  };
  for (DepthContact& contact : contacts) {
    number(contact.lower);
    number(contact.upper);
  }
  ordering_system_.contacts = std::move(contacts);
  for (NonlinearMark& mark : nonlinear_memory_.marks) number(mark.part);
  for (DepthContact& contact : nonlinear_memory_.contacts) {
    number(contact.lower);
    number(contact.upper);
  }
  sort_marks(nonlinear_memory_.marks);
  part_ids_.clear();
  for (const Part& part : scene.parts) part_ids_.push_back(part.id);
}

Status ReliefSession::update_layers(const Request& request) {
  const Scene& scene = request.scene;
  const ReliefOptions& options = request.options;
  const RunContext& context = request.context;
  StageClock& clock = request.clock;
  Status status = sheets_state_.refresh(sheets_key(scene, options.layers), [&]() -> Status {
    auto sheets = join_sheets(scene, options.layers, context);
    if (!sheets) return sheets.error();
    sheets_ = std::move(*sheets);
    clock.finish("mesh");
    return Done{};
  });
  if (!status) return status;
  Key key = layers_key(scene, options.layers);
  status = layers_state_.refresh(key.add(sheets_state_.version()), [&]() -> Status {
    auto layers = constrain_sheets(sheets_, scene, options.layers);
    if (!layers) return layers.error();
    relief_.layers = std::move(*layers);
    clock.finish("mesh");
    return Done{};
  });
  if (use_ != Use::many) {
    sheets_state_.forget();
    sheets_ = {};
  }
  return status;
}

Status ReliefSession::update_discretisation(const Request& request) {
  // Sums run in the order of faces, which relations "below" change.
  Key key = Key().add(sheets_state_.version());
  key.add(relief_.layers.face_part).add(relief_.layers.face_flap);
  return discretisation_state_.refresh(std::move(key), [&]() -> Status {
    discretisation_ = discretise(relief_.layers, request.context);
    if (request.context.cancelled()) return interrupted_error();
    begin_like(request.scene);
    return Done{};
  });
}

Status ReliefSession::update_inflation(const Request& request) {
  const Scene& scene = request.scene;
  const ReliefOptions& options = request.options;
  const RunContext& context = request.context;
  StageClock& clock = request.clock;
  const LayeredMesh& mesh = relief_.layers;
  Key roles = Key().add(discretisation_state_.version()).add(mesh.node_role);
  for (const RampNode& node : mesh.ramp_nodes) roles.add(node.node).add(node.below);
  Status status = poisson_state_.refresh(std::move(roles), [&]() -> Status {
    poisson_.emplace(mesh, discretisation_,
                     use_ == Use::many ? Refactorisation::incremental : Refactorisation::complete,
                     context);
    if (context.cancelled()) return interrupted_error();
    return Done{};
  });
  if (!status) return status;
  Key key = inflation_key(scene, options.inflation);
  key.add(poisson_state_.version()).add(boundary_key(mesh));
  status = inflation_state_.refresh(std::move(key), [&]() -> Status {
    auto inflation = inflate({mesh, discretisation_, scene}, options.inflation, *poisson_, context);
    if (!inflation) return inflation.error();
    inflation_ = std::move(*inflation);
    clock.finish("inflate");
    return Done{};
  });
  if (use_ != Use::many) {
    poisson_state_.forget();
    poisson_.reset();
  }
  return status;
}

Status ReliefSession::update_ordering(const Request& request) {
  const Scene& scene = request.scene;
  const ReliefOptions& options = request.options;
  const RunContext& context = request.context;
  StageClock& clock = request.clock;
  Key key = ordering_key(relief_.layers, scene, options.ordering);
  key.add(Method::approximate).add(inflation_state_.version());
  return heights_state_.refresh(std::move(key), [&]() -> Status {
    auto ordering = order_depth({relief_.layers, discretisation_, inflation_, scene},
                                options.ordering, ordering_system_, context);
    if (!ordering) return ordering.error();
    relief_.inflation = inflation_;
    relief_.ordering = std::move(*ordering);
    relief_.nonlinear = {};
    relief_.snapshots.clear();
    clock.finish("order");
    return Done{};
  });
}

/// Hides in place: what is seen stays, and what was hidden once is so in models of what is seen.
Status ReliefSession::update_hidden(const Request& request) {
  if (!request.options.hidden) return Done{};
  return hidden_state_.refresh(Key().add(heights_state_.version()), [&]() -> Status {
    HiddenSheets sheets = hide_sheets(
        {relief_.layers, discretisation_, request.scene, relief_.inflation, relief_.ordering},
        flaps_, request.context);
    if (use_ != Use::many) flaps_.reset();
    if (request.context.cancelled()) return interrupted_error();
    relief_.inflation = std::move(sheets.inflation);
    relief_.ordering = std::move(sheets.ordering);
    relief_.overlap_samples = sheets.overlap_samples;
    relief_.overlap_worst = sheets.overlap_worst;
    request.clock.finish("hide");
    return Done{};
  });
}

Status ReliefSession::update_nonlinear(const Request& request) {
  const Scene& scene = request.scene;
  const ReliefOptions& options = request.options;
  const RunContext& context = request.context;
  StageClock& clock = request.clock;
  Key key = ordering_key(relief_.layers, scene, options.ordering);
  key.add(Method::nonlinear).add(inflation_state_.version()).add(nonlinear_key(options.nonlinear));
  return heights_state_.refresh(std::move(key), [&]() -> Status {
    NonlinearOptions nonlinear = options.nonlinear;
    nonlinear.epsilon = options.ordering.epsilon;
    nonlinear.wanted = options.ordering.wanted;
    nonlinear.bumps = options.inflation;
    auto solution = solve_nonlinear({relief_.layers, discretisation_, inflation_, scene}, nonlinear,
                                    nonlinear_memory_, ordering_system_, context);
    if (!solution) return solution.error();
    nonlinear_memory_ = std::move(solution->memory);
    relief_.inflation = std::move(solution->inflation);
    relief_.ordering = std::move(solution->ordering);
    relief_.nonlinear = std::move(solution->report);
    relief_.snapshots = std::move(solution->snapshots);
    clock.finish("nonlinear");
    return Done{};
  });
}

}  // namespace relievo::relief
