#include <foredraw/io/file_lender.h>

#include <foredraw/io/image/images.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/platform/files.h>

namespace foredraw {

namespace {

std::optional<Loan<Scene>> read_lent_scene(const std::string& path, const SceneInput& how, Diagnostics& diagnostics) {
  if (path == "-") {
    diagnostics.error({}, "no-such-file", "an option must name a file, but '-' is standard input",
                      "give the path of a scene");
    return std::nullopt;
  }
  auto file = read_scene(path, diagnostics, how);
  if (!file) return std::nullopt;
  return Loan<Scene>{std::make_shared<const Scene>(std::move(file->scene)), file->bytes, file->stamp};
}

std::optional<Loan<Image>> read_lent_image(const std::string& path, const SceneInput& how, Diagnostics& diagnostics) {
  auto bytes = read_file(path, diagnostics, FileRead::all_of_it, how.files.get());
  if (!bytes) return std::nullopt;
  auto facts = checked_image_facts(*bytes, {.file = path}, diagnostics);
  if (!facts) return std::nullopt;
  Image image{.name = path, .bytes = Shared<std::byte>(std::move(*bytes)), .facts = *facts};
  const std::uint64_t length = image.bytes.size();
  const Stamp stamp = image.bytes.stamp();
  return Loan<Image>{std::make_shared<const Image>(std::move(image)), length, stamp};
}

template <class Content, class Read>
std::optional<Loan<Content>> kept(std::map<std::string, Loan<Content>>& read_before, const std::string& path,
                                  Read read) {
  if (const auto known = read_before.find(path); known != read_before.end()) return known->second;
  auto loan = read();
  if (loan) read_before.emplace(path, *loan);
  return loan;
}

}  // namespace

std::optional<Loan<Scene>> FileLender::scene(const std::string& path, Diagnostics& diagnostics) const {
  const std::lock_guard lock(mutex_);
  return kept(read_.scenes, path, [&] { return read_lent_scene(path, how_, diagnostics); });
}

std::optional<Loan<Image>> FileLender::image(const std::string& path, Diagnostics& diagnostics) const {
  const std::lock_guard lock(mutex_);
  return kept(read_.images, path, [&] { return read_lent_image(path, how_, diagnostics); });
}

}  // namespace foredraw
