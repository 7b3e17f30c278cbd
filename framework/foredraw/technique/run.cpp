#include <foredraw/technique/run.h>

#include <algorithm>
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

void Run::attach_at(About where, Attachment attachment) const {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument("its attachment '" + name_of(attachment) + "' " + why);
  };
  if (const auto mistake = mistake_in(attachment)) refuse(*mistake);
  const auto is_there = [&](const Attached& other) {
    return other.about == where && name_of(*other.content) == name_of(attachment);
  };
  if (std::ranges::any_of(findings.attached, is_there)) refuse("is attached twice");
  findings.attached.push_back({std::make_shared<const Attachment>(std::move(attachment)), where});
}

}  // namespace foredraw
