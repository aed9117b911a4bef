#include "relief/session/stage_keys.h"

namespace relievo::relief {

Key sheets_key(const Scene& scene, const LayerOptions& options) {
  Key key;
  key.add(scene.width).add(scene.height).add(scene.parts.size());
  for (const Part& part : scene.parts) key.add(std::string_view(part.id)).add(part.outline);
  key.add(scene.joins.size());
  for (const Join& join : scene.joins) key.add(join.upper).add(join.lower).add(join.line);
  key.add(scene.robin.size());
  for (const RobinRange& range : scene.robin)
    key.add(range.upper).add(range.lower).add(range.from).add(range.to);
  for (const Relation& relation : scene.relations)
    if (relation.range)
      key.add(relation.upper).add(relation.range->first).add(relation.range->second);
  for (const Cue& cue : scene.cues)
    if (cue.kind == CueKind::crease) key.add(cue.part).add(cue.line);
  key.add(options.vertex_budget).add(options.edge_length);
  return key.add(options.max_nodes);
}

namespace {

void add_cues(const Scene& scene, bool bulges, Key& key) {
  for (const Cue& cue : scene.cues)
    if ((cue.kind == CueKind::bulge) == bulges)
      key.add(cue.part).add(cue.kind).add(cue.line).add(cue.value);
}

}  // namespace

Key layers_key(const Scene& scene, const LayerOptions& options) {
  Key key;
  key.add(options.glue).add(options.attach).add(scene.relations.size());
  for (const Relation& relation : scene.relations)
    key.add(relation.upper).add(relation.lower).add(relation.kind).add(relation.range.has_value());
  for (const Part& part : scene.parts) key.add(part.d < 0);
  for (const RobinRange& range : scene.robin)
    key.add(range.alpha0.has_value())
        .add(range.alpha0.value_or(0))
        .add(range.rho.has_value())
        .add(range.rho.value_or(0));
  return key;
}

Key boundary_key(const LayeredMesh& mesh) {
  Key key;
  key.add(mesh.node_role).add(mesh.ramps.size());
  for (const RobinRamp& ramp : mesh.ramps) key.add(ramp.length).add(ramp.alpha0).add(ramp.rho);
  for (const RampNode& node : mesh.ramp_nodes)
    key.add(node.node).add(node.ramp).add(node.below).add(node.t).add(node.mass);
  for (const BumpNode& node : mesh.bump_nodes) key.add(node.node).add(node.ramp).add(node.t);
  return key;
}

Key inflation_key(const Scene& scene, const InflationOptions& options) {
  Key key;
  for (const Part& part : scene.parts) key.add(part.c).add(part.d).add(part.flat);
  add_cues(scene, true, key);
  return key.add(options.alpha0).add(options.rho);
}

Key ordering_key(const LayeredMesh& mesh, const Scene& scene, const OrderingOptions& options) {
  Key key;
  for (const DepthPair& pair : mesh.constraints)
    key.add(pair.lower).add(pair.upper).add(pair.equal);
  for (const Part& part : scene.parts) key.add(part.d < 0).add(part.lean);
  add_cues(scene, false, key);
  for (const Relation& relation : scene.relations)
    key.add(relation.upper).add(relation.lower).add(relation.kind).add(relation.range.has_value());
  return key.add(options.epsilon)
      .add(options.start_active)
      .add(options.wanted.straight_limbs)
      .add(options.wanted.close_caps);
}

Key nonlinear_key(const NonlinearOptions& options) {
  Key key;
  key.add(options.lambda_bnd).add(options.lambda_shift).add(options.tolerance);
  return key.add(options.max_iterations).add(options.anderson_depth).add(options.snapshots);
}

}  // namespace relievo::relief
