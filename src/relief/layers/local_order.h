#pragma once

#include <vector>

#include "relief/layers/sheet_mesh.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A relation of the scene on the mesh.
struct PlacedRelation {
  int index = -1;  ///< in the scene
  int upper = -1;
  int lower = -1;
  RelationKind kind = RelationKind::above;
  bool limited = false;       ///< it has a range; otherwise it holds everywhere
  std::vector<int> vertices;  ///< points of the range in its direction; none if it has collapsed
};

/// How two parts lie compared with their order.
enum class Sense {
  usual,
  swapped,  ///< the part in front in the order lies behind
  mixed,    ///< some faces are usual, some swapped
};

/// The order of the faces in each stack where relations "below" put parts behind others against
/// the order of parts.
struct LocalOrder {
  std::vector<int> faces;  ///< #F, by triangle, back to front; empty: all in the order of parts
  std::vector<int> place;  ///< #F, index of each face in `faces`; or empty

  bool is_usual() const { return faces.empty(); }
};

/// Places the relations of the scene; `runs` (one per relation with a range, in order) are their
/// ranges on the mesh.
std::vector<PlacedRelation> place_relations(const Scene& scene, const std::vector<LoopRun>& runs,
                                            const SheetMesh& mesh);

/// Orders the faces of each stack. Where the two parts of a relation "below" overlap, every
/// triangle takes its sense from the nearest part of the upper outline, counted in steps from
/// triangle to triangle: behind from the relation's ranges, in front from the rest. So the sense
/// changes halfway between a range and the rest, and an overlap with all of its outline "below" is
/// behind as a whole. Fails with contradiction, naming both relations, if ranges share more than an
/// end and one puts a part behind another while the other puts it in front of the same part, or of
/// one that covers it. O(T) for each pair of parts with such a relation.
Result<LocalOrder> find_local_order(const SheetMesh& mesh, const Scene& scene,
                                    const std::vector<PlacedRelation>& relations);

/// Returns how two parts lie around a base vertex; usual if they overlap in no triangle there.
Sense sense_at(const SheetMesh& mesh, const LocalOrder& order, int vertex, int lower, int upper);

}  // namespace relievo::relief
