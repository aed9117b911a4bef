#pragma once

#include "relief/surface/surface_sample.h"
#include "relief/surface/visible_sheet.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// Turns heights into an unfinished surface with texture coordinates on the drawing and analytic
/// normals N ~ (-1/2 grad u - |f| grad g, |f|). Every part of the scene has a run of triangles,
/// which is empty if none of its faces is kept. After vertices at one position are merged, a relief
/// is open only along the drawing's silhouette. Fails with usage, limit (2^24 triangles) or
/// interrupted. Near-linear in faces.
Result<Model> assemble_model(const SolvedSurface& surface, const ModelOptions& options,
                             const RunContext& context = {});

/// Assembles the same triangles without walls, as Visibility::relief whatever the options say, and
/// lists the edges where walls would stand. Fails as assemble_model. Near-linear in faces.
Result<VisibleSheet> assemble_visible_sheet(const SolvedSurface& surface,
                                            const ModelOptions& options,
                                            const RunContext& context = {});

}  // namespace relievo::relief
