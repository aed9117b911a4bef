#pragma once

#include <vector>

#include "relievo/scene.h"
#include "understanding/joins/join_proposals.h"

namespace relievo::understanding {

/// A layered drawing with its guessed connections.
struct ConnectedScene {
  Scene scene;
  JoinProposals proposals;  ///< the guesses among the connections of the scene
};

/// Connects the parts of a layered drawing by the guesses of propose_layer_joins. Connections that
/// the scene has already are the author's and stand: nothing is guessed for the upper part of a
/// join, relation or range, or for the lower part of a `joined` relation. Where the author gave
/// any, no joins are guessed, and limbs are tied in place of being joined. With `amounts`, parts
/// get a c that makes them about as deep as they are narrow, and those that look hollow a negative
/// d. Near-linear as propose_layer_joins.
ConnectedScene connect_scene(Scene scene, bool amounts, const PartColors& colors = {},
                             const std::vector<Point2>& anchors = {});

}  // namespace relievo::understanding
