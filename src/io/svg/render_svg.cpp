#include "io/svg/render_svg.h"

#include <cairo.h>
#include <librsvg/rsvg.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <utility>

namespace relievo {
namespace {

constexpr int max_side = 16384;
constexpr int64_t max_pixels = 100000000;

struct Release {
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(GError* error) const { g_error_free(error); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

Error render_error(GError* cause) {
  const Owned<GError> owned(cause);
  const std::string message = cause ? cause->message : "unknown";
  const bool for_memory = message.find("emory") != std::string::npos;
  return {for_memory ? ErrorCode::limit : ErrorCode::bad_input,
          "the drawing cannot be rendered: " + message, "svg"};
}

/// Converts premultiplied native-endian ARGB to straight RGBA.
void straight_rgba(cairo_surface_t* surface, Image8& image) {
  const int width = image.width;
  const int height = image.height;
  cairo_surface_flush(surface);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < height; ++y) {
    const auto* row = reinterpret_cast<const uint32_t*>(data + static_cast<size_t>(y) * stride);
    for (int x = 0; x < width; ++x) {
      const uint32_t alpha = row[x] >> 24;
      const auto channel = [&](int shift) {
        const uint32_t value = row[x] >> shift & 255;
        return static_cast<uint8_t>(alpha ? std::min(255u, (value * 255 + alpha / 2) / alpha) : 0);
      };
      image.at(x, y, 0) = channel(16);
      image.at(x, y, 1) = channel(8);
      image.at(x, y, 2) = channel(0);
      image.at(x, y, 3) = static_cast<uint8_t>(alpha);
    }
  }
}

Status rasterize(const understanding::PaintableSvg& svg, Image8& image) {
  GError* error = nullptr;
  const Owned<RsvgHandle> handle(rsvg_handle_new_from_data(
      reinterpret_cast<const guint8*>(svg.text.data()), svg.text.size(), &error));
  if (!handle) return render_error(error);
  const Owned<cairo_surface_t> surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    return Error{ErrorCode::limit, "there is not enough memory for the picture of the drawing",
                 "svg"};
  }
  const Owned<cairo_t> context(cairo_create(surface.get()));
  cairo_scale(context.get(), image.width / svg.width, image.height / svg.height);
  const RsvgRectangle viewport{0, 0, svg.width, svg.height};
  if (!rsvg_handle_render_document(handle.get(), context.get(), &viewport, &error)) {
    return render_error(error);
  }
  straight_rgba(surface.get(), image);
  return Done{};
}

constexpr size_t max_message = 1000;
constexpr rlim_t max_complaint = 1 << 16;  ///< bytes that the process may write to stderr
constexpr int crashed = 2;                 ///< exit code of the process
constexpr int gave_up = 3;                 ///< likewise, with an error in the report

Error too_little_memory() {
  return {ErrorCode::limit, "there is not enough memory to paint the drawing; make it smaller",
          "svg"};
}

/// The head of the memory that both processes share; the pixels follow.
struct Report {
  ErrorCode code;
  char message[max_message];
  char where[max_message];
};

class SharedMemory {
 public:
  explicit SharedMemory(size_t size)
      : size_(size),
        data_(mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {}
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  ~SharedMemory() {
    if (ok()) munmap(data_, size_);
  }
  bool ok() const { return data_ != MAP_FAILED; }
  Report& report() const { return *static_cast<Report*>(data_); }
  uint8_t* pixels() const { return static_cast<uint8_t*>(data_) + sizeof(Report); }

 private:
  size_t size_;
  void* data_;
};

/// A pipe with both ends.
struct Pipe {
  int ends[2] = {-1, -1};
  Pipe() {
    if (pipe(ends) != 0) ends[0] = ends[1] = -1;
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  void close_end(int which) {
    if (ends[which] >= 0) close(ends[which]);
    ends[which] = -1;
  }
};

void bound(int resource, rlim_t most) {
  rlimit limit = {};
  if (getrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0) return;
  limit.rlim_max = limit.rlim_cur = std::min({limit.rlim_cur, limit.rlim_max, most});
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

/// Returns the bytes of address space of this process.
rlim_t present_memory() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  unsigned long long pages = 0;
  if (file == nullptr) return 0;
  const int found = std::fscanf(file, "%llu", &pages);
  std::fclose(file);
  return found == 1 ? pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : 0;
}

/// Sanitizers take terabytes of address space and read tables from files, so limits cannot hold.
#ifdef __SANITIZE_ADDRESS__
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif
/// Wall time / processor time that a process may take beside others. With a sanitizer it may hang
/// (see paint_apart).
constexpr double patience = sanitized ? 1 : 10;

void confine(const PaintLimits& limits, uint64_t pixels) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  for (const int signal : {SIGINT, SIGTERM, SIGABRT, SIGSEGV}) std::signal(signal, SIG_DFL);
  bound(RLIMIT_CORE, 0);
  bound(RLIMIT_FSIZE, max_complaint);
  bound(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds)));
  if (sanitized) return;
  bound(RLIMIT_AS, present_memory() + limits.memory + 16 * pixels);
  if (!limits.fonts) bound(RLIMIT_NOFILE, 0);
}

void leave(const Error& error, Report& report) {
  report.code = error.code;
  std::strncpy(report.message, error.message.c_str(), max_message - 1);
  std::strncpy(report.where, error.where.c_str(), max_message - 1);
}

/// Does the work of the process and returns its exit code.
int work(int width, int height, const std::function<Status(Image8&)>& paint,
         const SharedMemory& shared) {
  try {
    Image8 image(width, height, 4);
    const Status status = paint(image);
    if (status) {
      std::copy(image.pixels.begin(), image.pixels.end(), shared.pixels());
      return 0;
    }
    leave(status.error(), shared.report());
  } catch (const std::bad_alloc&) {
    leave(too_little_memory(), shared.report());
  } catch (...) {
    // Panics of libraries in other languages end this process only.
    return crashed;
  }
  return gave_up;
}

/// Reads the process's stderr until it ends or `seconds` have passed; `in_time` becomes whether it
/// ended.
std::string listen(int from, double seconds, bool& in_time) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  std::string said;
  while (true) {
    const std::chrono::duration<double, std::milli> left = end - Clock::now();
    pollfd waiting{from, POLLIN, 0};
    const int ready = poll(&waiting, 1, std::max(0, static_cast<int>(left.count())));
    if (ready < 0 && errno == EINTR) continue;
    in_time = ready > 0;
    if (!in_time) return said;
    char buffer[4096];
    const ssize_t count = read(from, buffer, sizeof buffer);
    if (count <= 0) return said;
    if (said.size() < max_complaint) said.append(buffer, static_cast<size_t>(count));
  }
}

Error failure_of(int status, bool in_time, double seconds, const std::string& said,
                 const Report& report) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == gave_up)
    return {report.code, report.message, report.where};
  if (!in_time || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU))
    return {ErrorCode::limit,
            "the drawing takes more than " + std::to_string(static_cast<int>(seconds)) +
                " s to paint; simplify its filters, or export it as a picture and use that",
            "svg"};
  const bool out_of_memory = said.find("alloc") != std::string::npos ||
                             said.find("temporarily unavailable") != std::string::npos ||
                             said.find("annot allocate memory") != std::string::npos;
  if (out_of_memory) return too_little_memory();
  return {ErrorCode::bad_input,
          "the drawing cannot be painted: the renderer of SVG gave up on one of its filters, "
          "patterns or gradients; simplify it",
          "svg"};
}

Result<Image8> paint_once(int width, int height, const PaintLimits& limits,
                          const std::function<Status(Image8&)>& paint) {
  const size_t pixels = static_cast<size_t>(width) * height;
  const SharedMemory shared(sizeof(Report) + 4 * pixels);
  Pipe complaints;
  if (!shared.ok() || complaints.ends[0] < 0) return too_little_memory();
  Image8 image(width, height, 4);
  const pid_t child = fork();
  if (child < 0) return too_little_memory();
  if (child == 0) {
    dup2(complaints.ends[1], STDERR_FILENO);
    confine(limits, pixels);
    _exit(work(width, height, paint, shared));
  }
  complaints.close_end(1);
  bool in_time = false;
  const std::string said = listen(complaints.ends[0], patience * limits.seconds, in_time);
  if (!in_time) kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!in_time || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return failure_of(status, in_time, limits.seconds, said, shared.report());
  std::copy(shared.pixels(), shared.pixels() + 4 * pixels, image.pixels.begin());
  return image;
}

}  // namespace

Result<Drawing> render_svg(const understanding::PaintableSvg& svg, int width, int height) {
  if (width < 1 || height < 1 || width > max_side || height > max_side ||
      static_cast<int64_t>(width) * height > max_pixels) {
    return Error{ErrorCode::limit,
                 "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " px is outside the limits",
                 "svg"};
  }
  PaintLimits limits;
  limits.fonts =
      svg.text.find("<text") != std::string::npos || svg.text.find(":text") != std::string::npos;
  auto image =
      paint_apart(width, height, limits, [&](Image8& pixels) { return rasterize(svg, pixels); });
  if (!image) return image.error();
  return Drawing{std::move(*image)};
}

Result<Image8> paint_apart(int width, int height, const PaintLimits& limits,
                           const std::function<Status(Image8&)>& paint) {
  Result<Image8> image = paint_once(width, height, limits, paint);
  // A sanitizer's allocator stays locked in the new process if another thread was in it at the
  // fork.
  for (int again = 0; sanitized && again < 2; ++again) {
    if (image || image.error().code != ErrorCode::limit) break;
    image = paint_once(width, height, limits, paint);
  }
  return image;
}

}  // namespace relievo
