#include "programs/commands/check_planning.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {

namespace {

std::string_view first_head(const Source& source) {
  return source.data().empty() ? std::string_view() : source.data().front().head();
}

bool is_domain(const Source& source) {
  const std::string_view head = first_head(source);
  if (head == "operator" || head == "domain") return true;
  return head == "define" && source.data().front().size() > 1 && !source.data().front()[1].is_form("problem");
}

}  // namespace

bool PlanningCheck::knows(const Source& source) {
  constexpr std::array<std::string_view, 7> heads{"define", "operator", "types",  "initials",
                                                  "goals",  "preconds", "effects"};
  return std::ranges::find(heads, first_head(source)) != heads.end();
}

Result<std::string> PlanningCheck::check_domain(const Source& source, const Source* next) {
  domain_.reset();
  wrong_domain_ = source;
  Result<forms::PlanningDomain> domain = forms::read_planning_domain(source, next);
  if (!domain) return fail(domain);
  wrong_domain_.reset();
  domain_ = std::move(*domain);
  const Datum& form = domain_->form;
  if (domain_->language == forms::PlanningLanguage::operators) return counted(form[6].size(), "operator");
  return fmt::format("domain {}: {}, {}", form[1].text(), counted(form[4].size(), "predicate"),
                     counted(form[6].size(), "action"));
}

Result<std::string> PlanningCheck::check(const Source& source, const Source* next) {
  if (is_domain(source)) return check_domain(source, next);
  if (wrong_domain_) {
    const Result<void> checked = forms::check_planning_problem(source, *wrong_domain_);
    if (!checked) return fail(checked);
    return std::string("nothing wrong is found, as far as its domain can be understood");
  }
  if (!domain_) {
    return fail("no-domain",
                source.file() + " belongs to a domain: name the domain's file before it, or with --domain");
  }
  const Result<Datum> problem = forms::read_planning_problem(source, *domain_);
  if (!problem) return fail(problem);
  const Datum& form = *problem;
  return fmt::format("problem: {}, {}, {}", counted(form[1].size(), "object"), counted(form[2].size(), "fact"),
                     counted(form[4].size() + form[5].size(), "goal"));
}

Result<void> PlanningCheck::use_domain(const std::string& path) {
  const Result<Source> source = forms::read_planning_source_file(path);
  if (!source) return fail(source);
  Result<forms::PlanningDomain> domain = forms::read_planning_domain(*source);
  if (!domain) return fail(domain);
  domain_ = std::move(*domain);
  return {};
}

}  // namespace pizarra::programs
