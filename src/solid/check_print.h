#pragma once

#include <string>
#include <vector>

#include "relievo/model.h"

namespace relievo {

/// What a printer, or a hand, makes of a part.
enum class PrintTrouble {
  loose,     ///< touches nothing of the rest
  thin,      ///< has walls that a nozzle cannot lay
  neck,      ///< hangs by so little that it breaks off
  overhang,  ///< has nothing below it while it is laid
};

struct PrintFinding {
  PrintTrouble trouble = PrintTrouble::loose;
  std::string part;
  double measure = 0;  ///< mm of the thinnest wall or of the neck, mm^2 that hang over; or 0
};

/// mm, of most printers.
constexpr double usual_nozzle = 0.4;

/// What is wrong with a solid that lies on its back, or stands with the drawing's up as its own,
/// of a model in mm: by kind, parts in their order. `loose` are ids of parts. Walls are found in
/// level cuts, by opening them with a disc as wide as the nozzle (mm, > 0), and count where a cut
/// above or below has them too; necks are narrower than three nozzles; faces hang over that are
/// more level than upright, off the plate. O(n log n) for each of at most 16 cuts.
std::vector<PrintFinding> check_print(const Model& model, const std::vector<std::string>& loose,
                                      double nozzle, bool standing = false);

/// "loose", "thin", "neck" or "overhang".
const char* name(PrintTrouble trouble);

/// The longest side, mm, with which a wall or a neck is wide enough where it is `size` now; 0 of
/// what no size mends.
double enough_size(const PrintFinding& finding, double nozzle, double size);

/// A finding in words, and what helps. `size` is the longest side, mm.
std::string describe(const PrintFinding& finding, double nozzle, double size);

}  // namespace relievo
