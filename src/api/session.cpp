#include "relievo/session.h"

#include "api/solid_of.h"
#include "io/overlay/mesh_lines.h"
#include "kernel/image/image_size.h"
#include "relief/maps/relief_maps.h"
#include "relief/session/build_relief.h"
#include "relief/session/relief_session.h"
#include "relief/surface/assemble_model.h"

namespace relievo {
namespace {

const Error nothing_built = {ErrorCode::usage, "nothing has been built yet", ""};

Error out_of_range(const char* option, const std::string& range) {
  return {ErrorCode::usage, "must be " + range, option};
}

bool within(double value, double least, double most) { return value >= least && value <= most; }

Status check(const BuildOptions& options) {
  if (options.vertices < 1) return out_of_range("vertices", "positive");
  if (!within(options.edge, 0, max_coordinate)) return out_of_range("edge", "a length in px");
  if (!within(options.alpha0, 0, 1)) return out_of_range("alpha0", "from 0 to 1");
  if (!(options.rho > 0 && options.rho <= max_rho)) return out_of_range("rho", "positive");
  if (!within(options.lambda_bnd, relief::min_lambda_bnd, relief::max_lambda_bnd))
    return out_of_range("lambda_bnd", "from 1e-6 to 1e6");
  if (!within(options.lambda_shift, relief::min_lambda_shift, relief::max_lambda_shift))
    return out_of_range("lambda_shift", "from 1e-3 to 100");
  return Done{};
}

relief::ReliefOptions options_of(const BuildOptions& options) {
  relief::ReliefOptions relief;
  relief.method = options.method;
  relief.layers.vertex_budget = options.vertices;
  relief.layers.edge_length = options.edge;
  relief.layers.glue = options.glue;
  relief.layers.attach = options.attach;
  relief.inflation.rho = options.rho;
  relief.inflation.alpha0 = options.alpha0;
  relief.nonlinear.lambda_bnd = options.lambda_bnd;
  relief.nonlinear.lambda_shift = options.lambda_shift;
  return relief;
}

BuildReport report_of(const relief::Relief& relief) {
  BuildReport report;
  report.vertices = relief.layers.node_vertex.size();
  report.faces = relief.layers.faces.size();
  report.equalities = relief.ordering.equalities;
  report.inequalities = relief.ordering.inequalities;
  report.active = relief.ordering.report.active;
  report.max_violation = relief.ordering.max_violation;
  report.worst_overlap = relief.ordering.overlap_worst;
  report.energy = relief.nonlinear.energy.total();
  report.converged = relief.nonlinear.status == SolveStatus::solved;
  for (const relief::StageTime& time : relief.times)
    if (!time.beside) report.milliseconds[time.stage] += time.milliseconds;
  report.warnings = relief.layers.warnings;
  return report;
}

}  // namespace

struct Session::State {
  Status update(const RunContext& context) {
    // The non-linear method stops within a tolerance, at a point that depends on its start.
    exact = !built || options.method == Method::nonlinear;
    if (exact) session = relief::ReliefSession();
    built = false;
    Status status = session.update(scene, options, context);
    built = status.ok();
    return status;
  }

  Scene scene;
  relief::ReliefOptions options;
  relief::ReliefSession session;
  bool built = false;
  bool exact = false;  ///< the last build started from nothing
};

Session::Session() : state_(std::make_unique<State>()) {}
Session::~Session() = default;
Session::Session(Session&& other) noexcept = default;
Session& Session::operator=(Session&& other) noexcept = default;

Result<BuildReport> Session::build(const Scene& scene, const BuildOptions& options,
                                   const RunContext& context) {
  if (Status status = check(options); !status) return status.error();
  if (Status status = validate(scene); !status) return status.error();
  state_->scene = scene;
  state_->options = options_of(options);
  if (Status status = state_->update(context); !status) return status.error();
  return report_of(state_->session.relief());
}

Status Session::make_exact(const RunContext& context) {
  if (!state_->built) return nothing_built;
  if (state_->exact) return Done{};
  state_->built = false;
  return state_->update(context);
}

Result<Model> Session::model(const ModelOptions& options, Field field,
                             const RunContext& context) const {
  if (!state_->built) return nothing_built;
  const relief::Relief& relief = state_->session.relief();
  if (field == Field::relief)
    return relief::assemble_model({relief.layers, relief.inflation, relief.ordering, state_->scene},
                                  options, context);
  relief::Relief shown;
  shown.inflation = relief.inflation;
  shown.ordering = relief.ordering;
  relief::keep_field(shown, field);
  return relief::assemble_model({relief.layers, shown.inflation, shown.ordering, state_->scene},
                                options, context);
}

Result<ReliefMaps> Session::maps(int longest, const RunContext& context) const {
  if (!state_->built) return nothing_built;
  const relief::Relief& relief = state_->session.relief();
  const ImageSize size = fitted_size(state_->scene.width, state_->scene.height, longest);
  return relief::rasterize_relief({relief.layers, relief.inflation, relief.ordering, state_->scene},
                                  size.width, size.height, context);
}

Result<Solid> Session::solid(const SolidOptions& options, const Drawing& drawing,
                             const RunContext& context) const {
  if (!state_->built) return nothing_built;
  return solid_of(state_->session.relief(), state_->scene, drawing, options, context);
}

Result<MeshLines> Session::lines() const {
  if (!state_->built) return nothing_built;
  return find_mesh_lines(state_->session.relief().layers, state_->options.inflation.alpha0);
}

}  // namespace relievo
