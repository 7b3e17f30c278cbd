#include <foredraw/technique/run.h>

#include <stdexcept>

namespace foredraw {

namespace {

template <class Content>
const Content& lent(const std::map<std::string, Loan<Content>>& loans, const std::string& path) {
  if (path.empty()) throw std::invalid_argument("an option that must name a file is empty");
  const auto loan = loans.find(path);
  if (loan == loans.end()) throw std::invalid_argument(path + " was not lent to this run");
  return *loan->second.content;
}

}  // namespace

const Scene& Run::scene(const ScenePath& named) const { return lent(loans.scenes, named.path); }

const Image& Run::image(const ImagePath& named) const { return lent(loans.images, named.path); }

}  // namespace foredraw
