#pragma once

#include "kernel/base/result.h"
#include "kernel/base/run_context.h"
#include "kernel/image/image.h"
#include "relief/drawing/drawing.h"
#include "relief/model/model.h"
#include "render/render_options.h"

namespace relievo {

/// An orthographic picture of the model: RGBA, straight alpha, sRGB. The front view of a window
/// over the whole canvas lies exactly on the drawing. Faces are seen from both sides; shadows and
/// ambient occlusion are traced, with noise that is the same in every run and for any number of
/// threads. `drawing` may be null unless the shading is textured. Errors: `usage` for options out
/// of range, `bad_input` for a model without triangles or with numbers that are not finite,
/// `limit` above 100 megapixels or 16384 px a side, `interrupted`. O(pixels * samples * rays).
Result<Image8> render_model(const Model& model, const Drawing* drawing,
                            const RenderOptions& options, const RunContext& context = {});

/// The front, three-quarter and side views beside each other at the same scale, each of
/// options.width x options.height px; yaw, pitch and window of the options are not used.
Result<Image8> render_contact_sheet(const Model& model, const Drawing* drawing,
                                    const RenderOptions& options, const RunContext& context = {});

}  // namespace relievo
