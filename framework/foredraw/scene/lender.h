#pragma once
// Scenes and images that options name: the host reads them, and stages borrow what it read.

#include <foredraw/base/content_hash.h>
#include <foredraw/base/diagnostics.h>
#include <foredraw/scene/image.h>
#include <foredraw/scene/scene.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace foredraw {

template <class Content>
struct Loan {
  std::shared_ptr<const Content> content;
  std::uint64_t bytes = 0;  ///< of the file itself, without those beside it
  Stamp stamp;              ///< of all that was read
};

/// How a host reads the files that options name, by their paths. nullopt, with an error, where a file can not be read
/// whole and right. Any number of threads may ask at once.
class Lender {
 public:
  virtual ~Lender() = default;
  virtual std::optional<Loan<Scene>> scene(const std::string& path, Diagnostics& diagnostics) const = 0;
  /// Its bytes are in it; they are encoded still.
  virtual std::optional<Loan<Image>> image(const std::string& path, Diagnostics& diagnostics) const = 0;
};

/// All that a plan borrowed, by path.
struct Loans {
  std::map<std::string, Loan<Scene>> scenes;
  std::map<std::string, Loan<Image>> images;
};
inline const Loans no_loans;

}  // namespace foredraw
