#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "benchmarks/characters.h"
#include "benchmarks/suites.h"
#include "relief/session/relief_session.h"

namespace relievo::benchmarks {
namespace {

using benchmark::State;

struct Edit {
  const char* name;
  std::function<void(Scene&, relief::ReliefOptions&)> make;
};

const Edit edits[] = {
    {"c_of_one_part_a_tenth_more",
     [](Scene& s, relief::ReliefOptions&) { s.parts.back().c *= 1.1; }},
    {"d_of_one_part_a_tenth_less",
     [](Scene& s, relief::ReliefOptions&) { s.parts.back().d *= 0.9; }},
    {"c_of_the_largest_part_doubled",
     [](Scene& s, relief::ReliefOptions&) { s.parts.front().c *= 2; }},
    {"flatter", [](Scene& s, relief::ReliefOptions&) { s.parts.back().flat = 0.3; }},
    {"leaning",
     [](Scene& s, relief::ReliefOptions&) {
       s.parts.front().lean = {0.2, 0.1};
     }},
    {"alpha0_a_tenth", [](Scene&, relief::ReliefOptions& o) { o.inflation.alpha0 = 0.1; }},
    {"rho_a_fifth_more", [](Scene&, relief::ReliefOptions& o) { o.inflation.rho *= 1.2; }},
    {"a_relation_dropped",
     [](Scene& s, relief::ReliefOptions&) {
       const int front = static_cast<int>(s.parts.size()) - 1;
       for (int lower = 0; lower < front; ++lower)
         s.relations.push_back({front, lower, RelationKind::free, std::nullopt});
     }},
    {"a_join_removed", [](Scene& s, relief::ReliefOptions&) { s.joins.pop_back(); }},
    {"an_outline_moved",
     [](Scene& s, relief::ReliefOptions&) {
       for (Ring& ring : s.parts.back().outline)
         for (Point2& p : ring) p.x += 1;
     }},
};

using Touch = std::tuple<int, int, double, double>;

/// Returns the points where parts touch, sorted.
std::vector<Touch> touches(const std::vector<relief::DepthContact>& contacts) {
  std::vector<Touch> result;
  for (const relief::DepthContact& contact : contacts)
    if (contact.closed)
      result.emplace_back(contact.lower, contact.upper, contact.position.x, contact.position.y);
  std::sort(result.begin(), result.end());
  return result;
}

int changes(const std::vector<Touch>& before, const std::vector<Touch>& after) {
  std::vector<Touch> different;
  std::set_symmetric_difference(before.begin(), before.end(), after.begin(), after.end(),
                                std::back_inserter(different));
  return static_cast<int>(different.size());
}

/// Times making the edit and taking it back in turn.
void run(State& state, const Edit& edit, const std::string& name) {
  const Scene plain = scene_of(name);
  const relief::ReliefOptions plain_options = options_for(40000);
  Scene scene = plain;
  relief::ReliefOptions options = plain_options;
  edit.make(scene, options);
  relief::ReliefSession session;
  bool ok = session.update(plain, plain_options).ok();
  const std::vector<Point2> vertices = session.relief().layers.vertices;
  const std::vector<Touch> before = touches(session.contacts());
  bool edited = false;
  for (auto _ : state) {
    edited = !edited;
    ok = ok && session.update(edited ? scene : plain, edited ? options : plain_options).ok();
  }
  ok = ok && session.update(scene, options).ok();
  if (!ok) return state.SkipWithError("cannot be built");
  const bool same_mesh = session.relief().layers.vertices == vertices;
  state.counters["changes"] = same_mesh ? changes(before, touches(session.contacts())) : -1;
  state.counters["iterations"] = session.relief().ordering.report.iterations;
}

}  // namespace

void register_edits() {
  for (const Character& character : characters())
    for (const Edit& edit : edits)
      benchmark::RegisterBenchmark(
          ("edit/" + std::string(character.name) + "/" + edit.name).c_str(),
          [&](State& state) { run(state, edit, character.name); })
          ->Unit(benchmark::kMillisecond)
          ->MeasureProcessCPUTime()
          ->UseRealTime();
}

}  // namespace relievo::benchmarks
