#include "relief/session/stage_keys.h"

namespace relievo::relief {
namespace {

void add_cues(const Scene& scene, bool bulges, Key& key) {
  for (const Cue& cue : scene.cues)
    if ((cue.kind == CueKind::bulge) == bulges) key.add(cue.part, cue.kind, cue.line, cue.value);
}

void add_relations(const Scene& scene, Key& key) {
  for (const Relation& relation : scene.relations)
    key.add(relation.upper, relation.lower, relation.kind, relation.range.has_value());
}

}  // namespace

Key sheets_key(const Scene& scene, const LayerOptions& options) {
  Key key;
  key.add(scene.width, scene.height, scene.parts.size());
  for (const Part& part : scene.parts) key.add(part.id, part.outline);
  key.add(scene.joins.size());
  for (const Join& join : scene.joins) key.add(join.upper, join.lower, join.line);
  key.add(scene.robin.size());
  for (const RobinRange& range : scene.robin)
    key.add(range.upper, range.lower, range.from, range.to);
  for (const Relation& relation : scene.relations)
    if (relation.range) key.add(relation.upper, relation.range->first, relation.range->second);
  for (const Cue& cue : scene.cues)
    if (cue.kind == CueKind::crease) key.add(cue.part, cue.line);
  return key.add(options.vertex_budget, options.edge_length, options.max_nodes);
}

Key layers_key(const Scene& scene, const LayerOptions& options) {
  Key key;
  key.add(options.glue, options.attach, scene.relations.size());
  add_relations(scene, key);
  for (const Part& part : scene.parts) key.add(part.d < 0);
  for (const RobinRange& range : scene.robin)
    key.add(range.alpha0.has_value(), range.alpha0.value_or(0), range.rho.has_value(),
            range.rho.value_or(0));
  return key;
}

Key boundary_key(const LayeredMesh& mesh) {
  Key key;
  key.add(mesh.node_role, mesh.ramps.size());
  for (const RobinRamp& ramp : mesh.ramps) key.add(ramp.length, ramp.alpha0, ramp.rho);
  for (const RampNode& node : mesh.ramp_nodes)
    key.add(node.node, node.ramp, node.below, node.t, node.mass);
  for (const BumpNode& node : mesh.bump_nodes) key.add(node.node, node.ramp, node.t);
  return key;
}

Key inflation_key(const Scene& scene, const InflationOptions& options) {
  Key key;
  for (const Part& part : scene.parts) key.add(part.c, part.d, part.flat);
  add_cues(scene, true, key);
  return key.add(options.alpha0, options.rho);
}

Key ordering_key(const LayeredMesh& mesh, const Scene& scene, const OrderingOptions& options) {
  Key key;
  for (const DepthPair& pair : mesh.constraints) key.add(pair.lower, pair.upper, pair.equal);
  for (const Part& part : scene.parts) key.add(part.d < 0, part.lean);
  add_cues(scene, false, key);
  add_relations(scene, key);
  return key.add(options.epsilon, options.start_active, options.straight_limbs, options.close_caps);
}

Key nonlinear_key(const NonlinearOptions& options) {
  return Key().add(options.lambda_bnd, options.lambda_shift, options.tolerance,
                   options.max_iterations, options.snapshots);
}

}  // namespace relievo::relief
