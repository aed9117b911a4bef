// Turns a layered drawing into a model: embed DRAWING MODEL, for example wolf.svg wolf.glb.
#include <relievo/export.h>
#include <relievo/read.h>
#include <relievo/session.h>

#include <cstdio>

namespace {

relievo::Status make_model(const char* drawing_file, const char* model_file) {
  const auto drawn = relievo::read_drawing(drawing_file);
  if (!drawn) return drawn.error();
  relievo::Session session;
  if (const auto built = session.build(drawn->scene); !built) return built.error();
  const auto model = session.model();
  if (!model) return model.error();
  const auto files = relievo::export_model(*model, drawn->drawing, model_file);
  if (!files) return files.error();
  return relievo::write_files(*files, drawn->files);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const relievo::Status made = make_model(argv[1], argv[2]);
  if (!made) std::fprintf(stderr, "%s\n", relievo::to_string(made.error()).c_str());
  return made ? 0 : 1;
}
