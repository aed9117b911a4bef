#pragma once

#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relief/surface/visible_sheet.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Turns heights into a surface with analytic normals N ~ (-1/2 grad u - |f| grad g, |f|) and
/// texture coordinates on the drawing. Every part of the scene has its run of triangles, empty
/// where nothing of it is kept. After vertices at one place are merged, the relief is open only
/// along the silhouette of the drawing. Fails with usage, limit (2^24 triangles) or interrupted.
/// Near-linear in faces.
Result<Model> assemble_model(const LayeredMesh& mesh, const Inflation& inflation,
                             const Ordering& ordering, const Scene& scene,
                             const ModelOptions& options, const RunContext& context = {});

/// The same triangles of the relief without walls, whatever visibility the options say, and where
/// these would stand. Fails as assemble_model. Near-linear in faces.
Result<VisibleSheet> assemble_visible_sheet(const LayeredMesh& mesh, const Inflation& inflation,
                                            const Ordering& ordering, const Scene& scene,
                                            const ModelOptions& options,
                                            const RunContext& context = {});

}  // namespace relievo::relief
