#include <foredraw/platform/shared_block.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace foredraw {

namespace {

[[noreturn]] void refuse(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

std::span<std::byte> mapped(int descriptor, std::size_t bytes, int protection) {
  void* at = ::mmap(nullptr, bytes, protection, MAP_SHARED | MAP_NORESERVE, descriptor, 0);
  if (at == MAP_FAILED) refuse("shared memory can not be mapped");
  return {static_cast<std::byte*>(at), bytes};
}

}  // namespace

SharedBlock::SharedBlock(std::size_t bytes, bool only_read) : descriptor_(-1) {
  const int made = ::memfd_create("foredraw", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (made < 0) refuse("shared memory can not be made");
  descriptor_ = ::fcntl(made, F_DUPFD_CLOEXEC, 10);  // clear of the numbers that children get theirs under
  ::close(made);
  if (descriptor_ < 0) refuse("shared memory can not be made");
  try {
    if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) refuse("shared memory can not be made");
    bytes_ = mapped(descriptor_, bytes, PROT_READ | PROT_WRITE);
    // This mapping stays writable; no other one can be made.
    const int seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL | (only_read ? F_SEAL_FUTURE_WRITE : 0);
    if (::fcntl(descriptor_, F_ADD_SEALS, seals) != 0) refuse("shared memory can not be sealed");
  } catch (...) {
    if (!bytes_.empty()) ::munmap(bytes_.data(), bytes_.size());
    ::close(descriptor_);
    throw;
  }
}

SharedBlock SharedBlock::handed(int descriptor, bool writable) {
  struct stat about {};
  if (::fstat(descriptor, &about) != 0) refuse("there is no shared memory");
  const auto bytes = static_cast<std::size_t>(about.st_size);
  return {descriptor, mapped(descriptor, bytes, writable ? PROT_READ | PROT_WRITE : PROT_READ)};
}

SharedBlock::SharedBlock(SharedBlock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), bytes_(std::exchange(other.bytes_, {})) {}

SharedBlock::~SharedBlock() {
  if (!bytes_.empty()) ::munmap(bytes_.data(), bytes_.size());
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace foredraw
