#pragma once
#include <foredraw/scene/subject.h>
#include <foredraw/technique/options.h>

namespace foredraw {

/// The row of a member that says what is seen and judged as one.
template <class Options>
void add_subject_row(OptionTable<Options>& table, SubjectUnit Options::*member) {
  const auto word_of = [](SubjectUnit unit) { return std::pair(std::string(text_of(unit)), unit); };
  table.template choice<SubjectUnit>(
      member, "subject",
      "What is seen and judged as one: mesh (each mesh by itself), character (all meshes of a skeleton; other meshes "
      "by "
      "themselves), or scene (everything that the scene shows)",
      {word_of(SubjectUnit::mesh), word_of(SubjectUnit::character), word_of(SubjectUnit::scene)});
}

}  // namespace foredraw
