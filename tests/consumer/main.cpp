// A program that has nothing but the installed package.
#include <relievo/export.h>
#include <relievo/read.h>
#include <relievo/render.h>
#include <relievo/session.h>

#include <cstdio>
#include <filesystem>

namespace {

using relievo::Done;
using relievo::Error;
using relievo::Result;
using relievo::Status;

relievo::Part square(const char* id, double from, double to) {
  return {id, {{{from, from}, {to, from}, {to, to}, {from, to}}}};
}

relievo::Scene two_squares() {
  relievo::Scene scene;
  scene.width = scene.height = 100;
  scene.parts = {square("lower", 10, 70), square("upper", 40, 90)};
  return scene;
}

Status expect(bool sound, const char* what) {
  return sound ? Status(Done{}) : Status(Error{relievo::ErrorCode::internal, "is wrong", what});
}

/// A session, its maps and a picture; an edit goes on from the build before.
Status use_session() {
  relievo::Session session;
  if (session.model()) return expect(false, "a model before anything is built");
  relievo::Scene scene = two_squares();
  relievo::BuildOptions options;
  options.vertices = 2000;
  for (const double c : {4.0, 2.0}) {
    scene.parts[1].c = c;
    const auto report = session.build(scene, options);
    if (!report) return report.error();
    if (Status s = expect(report->vertices > 1000 && report->max_violation < 1e-6, "report"); !s)
      return s;
  }
  const auto model = session.model({relievo::Visibility::orbit});
  if (!model) return model.error();
  const auto maps = session.maps(64);
  if (!maps) return maps.error();
  if (Status s = expect(maps->part.at(20, 20) == 0 && maps->part.at(50, 50) == 1, "part map"); !s)
    return s;
  const auto solid = session.solid({.base = relievo::BaseShape::plate});
  if (!solid) return solid.error();
  if (Status s = expect(solid->facts.pieces == 1 && solid->facts.volume > 0, "solid"); !s) return s;
  relievo::RenderOptions picture;
  picture.width = picture.height = 64;
  const auto rendered = relievo::render_model(*model, nullptr, picture);
  if (!rendered) return rendered.error();
  const auto file = relievo::encode_picture(*rendered);
  if (!file) return file.error();
  options.rho = -1;
  return expect(!session.build(scene, options), "an option out of range");
}

/// A layered drawing and a flat one.
Status use_files(const std::filesystem::path& examples) {
  const auto layered = relievo::read_drawing(examples / "bunny.svg");
  if (!layered) return layered.error();
  if (Status s = expect(!layered->proposed && layered->scene.parts.size() > 3, "bunny"); !s)
    return s;
  const auto flat = relievo::understand_picture(examples / "bear.png");
  if (!flat) return flat.error();
  if (Status s = expect(flat->proposed && flat->scene.parts.size() > 3, "bear"); !s) return s;
  return expect(!relievo::read_drawing(examples / "nothing"), "a file that is not there");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  Status status = use_session();
  if (status) status = use_files(argv[1]);
  if (!status) std::fprintf(stderr, "%s\n", relievo::to_string(status.error()).c_str());
  return status ? 0 : 1;
}
