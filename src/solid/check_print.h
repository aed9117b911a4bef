#pragma once

#include <string>
#include <vector>

#include "relievo/model.h"

namespace relievo {

/// Reasons why a part prints badly or breaks.
enum class PrintTrouble {
  loose,     ///< it touches no other part
  thin,      ///< it has walls that are too thin for the nozzle
  neck,      ///< it hangs by a neck so narrow that it may break off
  overhang,  ///< it has nothing below it while it is printed
};

struct PrintFinding {
  PrintTrouble trouble = PrintTrouble::loose;
  std::string part;
  double measure = 0;  ///< mm of the thinnest wall or the neck; mm^2 of an overhang; 0 if loose
  double enough = 0;   ///< mm, longest side with which a part is not too thin; 0: none was found
};

/// The nozzle of most printers, mm.
constexpr double usual_nozzle = 0.4;

/// Checks a solid, in mm, that is printed lying on its back or, if `standing`, upright. Returns its
/// findings by kind, parts in their order. `loose`: ids of loose parts. Thin walls are found in
/// level cuts, opened with a disc as wide as the nozzle (mm, > 0), and count if a cut above or
/// below has them too. Necks are narrower than three nozzles. Overhangs are faces off the plate
/// that look down and are more level than upright. Where a part is too thin, the model is checked
/// again at a few larger sizes, as if all of it grew. O(n log n) for each of at most 16 cuts of
/// each size.
std::vector<PrintFinding> check_print(const Model& model, const std::vector<std::string>& loose,
                                      double nozzle, bool standing = false);

/// Returns "loose", "thin", "neck" or "overhang".
const char* name(PrintTrouble trouble);

/// Describes a finding and its remedy.
std::string describe(const PrintFinding& finding);

}  // namespace relievo
