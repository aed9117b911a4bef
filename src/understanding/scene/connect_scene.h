#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"
#include "understanding/joins/join_proposals.h"

namespace relievo::understanding {

/// A layered drawing as it was understood.
struct ConnectedScene {
  Scene scene;
  JoinProposals proposals;  ///< what of the scene was guessed; by part, in its order
};

/// Connects the parts of a layered drawing as propose_layer_joins proposes. What the drawing itself
/// says stands: of the upper part of a join, relation or range, or the lower one that is `joined`
/// from behind, nothing is guessed, and where there is any, no more joins are guessed, but what
/// they would hold is tied. Where `amounts`, parts get a c that makes them about as deep as they
/// are narrow, and those that look hollow a negative d. Near-linear as propose_layer_joins.
ConnectedScene connect_scene(Scene scene, bool amounts, const PartColors& colors = {},
                             const std::vector<Point2>& anchors = {});

}  // namespace relievo::understanding
