#include "relief/pipeline/relief_session.h"

#include "relief/discretisation/discretise.h"
#include "relief/pipeline/stage_keys.h"

namespace relievo {

/// What an update was asked for.
struct ReliefSession::Request {
  const Scene& scene;
  const ReliefOptions& options;
  const RunContext& context;
  StageClock& clock;
};

Status ReliefSession::update(const Scene& scene, const ReliefOptions& options,
                             const RunContext& context) {
  if (Status status = validate(scene); !status) return status;
  relief_.times.clear();
  std::vector<StageTime> times;
  StageClock clock(times);
  const RunContext timed = clock.listen(context);
  const Request request{scene, options, timed, clock};
  if (Status status = update_layers(request); !status) return status;
  if (Status status = update_inflation(request); !status) return status;
  const bool jointly = options.method == Method::nonlinear;
  if (Status status = jointly ? update_jointly(request) : update_ordering(request); !status)
    return status;
  relief_.times = std::move(times);
  return Done{};
}

Relief ReliefSession::take() && { return std::move(relief_); }

Status ReliefSession::update_layers(const Request& request) {
  const auto& [scene, options, context, clock] = request;
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
    auto layers = constrain_sheets(sheets_, scene, options.layers.glue);
    if (!layers) return layers.error();
    relief_.layers = std::move(*layers);
    clock.finish("mesh");
    return Done{};
  });
  if (status && use_ == Use::one) sheets_ = {};
  return status;
}

Status ReliefSession::update_inflation(const Request& request) {
  const auto& [scene, options, context, clock] = request;
  const LayeredMesh& mesh = relief_.layers;
  Status status =
      discretisation_state_.refresh(Key().add(sheets_state_.version()), [&]() -> Status {
        discretisation_ = discretise(mesh, context);
        if (context.cancelled()) return interrupted_error();
        ordering_system_ = {};
        ordering_system_.keep_rounds = use_ == Use::many;
        return Done{};
      });
  if (!status) return status;
  Key roles = Key().add(discretisation_state_.version()).add(mesh.node_role);
  status = poisson_state_.refresh(std::move(roles), [&]() -> Status {
    poisson_.emplace(mesh, discretisation_,
                     use_ == Use::many ? Refactorisation::incremental : Refactorisation::complete,
                     context);
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
  if (use_ == Use::one) poisson_.reset();
  return status;
}

Status ReliefSession::update_ordering(const Request& request) {
  const auto& [scene, options, context, clock] = request;
  Key key = ordering_key(relief_.layers, scene, options.ordering);
  key.add(Method::approximate).add(inflation_state_.version());
  return heights_state_.refresh(std::move(key), [&]() -> Status {
    auto ordering = order_depth({relief_.layers, discretisation_, inflation_, scene},
                                options.ordering, ordering_system_, context);
    if (!ordering) return ordering.error();
    relief_.inflation = inflation_;
    relief_.ordering = std::move(*ordering);
    relief_.joint = {};
    clock.finish("order");
    return Done{};
  });
}

Status ReliefSession::update_jointly(const Request& request) {
  const auto& [scene, options, context, clock] = request;
  Key key = ordering_key(relief_.layers, scene, options.ordering);
  key.add(Method::nonlinear).add(inflation_state_.version()).add(joint_key(options.joint));
  return heights_state_.refresh(std::move(key), [&]() -> Status {
    JointOptions joint = options.joint;
    joint.epsilon = options.ordering.epsilon;
    joint.max_rounds = options.ordering.max_rounds;
    auto solution = solve_jointly(relief_.layers, scene, inflation_, joint, context);
    if (!solution) return solution.error();
    relief_.inflation = std::move(solution->inflation);
    relief_.ordering = std::move(solution->ordering);
    relief_.joint = std::move(solution->report);
    clock.finish("nonlinear");
    return Done{};
  });
}

}  // namespace relievo
