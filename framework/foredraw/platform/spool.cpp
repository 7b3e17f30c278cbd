#include <foredraw/platform/private/descriptor.h>
#include <foredraw/platform/spool.h>

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace foredraw {

struct Spool::File {
  Descriptor descriptor;
  std::atomic<std::uint64_t> end = 0;
};

namespace {

int nameless_file(const std::filesystem::path& folder) {
  std::string name = (folder / "foredraw-spool-XXXXXX").string();
  const int number = ::mkstemp(name.data());
  if (number < 0) {
    throw std::runtime_error("no temporary file can be made in '" + folder.string() + "': " + std::strerror(errno));
  }
  ::unlink(name.c_str());
  return number;
}

}  // namespace

Spool::Spool(const std::filesystem::path& folder)
    : file_(new File{Descriptor(nameless_file(folder.empty() ? std::filesystem::temp_directory_path() : folder))}) {}

Spool::~Spool() = default;

Spool::Place Spool::put(std::string_view text) {
  const Place place{file_->end.fetch_add(text.size()), text.size()};
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t put = ::pwrite(file_->descriptor.get(), text.data() + done, text.size() - done,
                                 static_cast<off_t>(place.offset + done));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) throw std::runtime_error(std::string("a temporary file cannot be written: ") + std::strerror(errno));
    done += static_cast<std::size_t>(put);
  }
  return place;
}

std::string Spool::get(const Place& place) const {
  std::string text(place.length, '\0');
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t got = ::pread(file_->descriptor.get(), text.data() + done, text.size() - done,
                                static_cast<off_t>(place.offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw std::runtime_error("a temporary file cannot be read");
    done += static_cast<std::size_t>(got);
  }
  return text;
}

}  // namespace foredraw
