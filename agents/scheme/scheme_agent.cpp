#include "agents/scheme/scheme_agent.hpp"

#include <fmt/format.h>

#include "agents/scheme/program_contract.hpp"

namespace pizarra::scheme {

namespace {

constexpr Duration look_pause = 200ms;
constexpr Duration patience_when_leaving = 1s;

}  // namespace

struct SchemeAgent::Life {
  Life(runtime::AgentContext& context, const runtime::Contract& contract)
      : service(context, contract), caller(context, service) {}

  runtime::Service service;
  runtime::Caller caller;
  LeaseId lease = 0;
  Time renewed{};
  std::shared_ptr<PartRunner> runner;
  std::optional<RunningProgram> running;
  std::optional<Result<void>> ended;
  Job serving;
};

SchemeAgent::SchemeAgent(runtime::AgentContext context, SchemeOptions options)
    : context_(std::move(context)),
      options_(std::move(options)),
      file_(options_.file),
      allowance_(options_.messages_per_s) {
  if (!options_.log) options_.log = [](const std::string&) {};
}

Result<SchemeAgent::Loaded> SchemeAgent::load(const std::string& text) const {
  Result<std::unique_ptr<forms::AgentProgram>> program =
      forms::AgentProgram::load(context_.name, text, file_.name(), options_.limits);
  if (!program) return fail(program);
  Result<runtime::Contract> contract = contract_of(program->get(), context_.name);
  if (!contract) return fail(contract);
  return Loaded{std::move(*program), std::move(*contract)};
}

SchemeAgent::Loaded SchemeAgent::without_program() const {
  return {nullptr, contract_of(nullptr, context_.name).value()};
}

std::optional<SchemeAgent::Loaded> SchemeAgent::look_for_another() {
  const std::optional<Result<std::string>> saved = file_.look();
  if (!saved) return std::nullopt;
  Result<Loaded> loaded = *saved ? load(**saved) : Result<Loaded>(fail(*saved));
  refused_ = loaded ? std::string() : describe(loaded.error());
  options_.log(loaded ? fmt::format("{} is loaded", file_.name()) : refused_);
  if (!loaded) return std::nullopt;
  has_program_ = true;
  return std::move(*loaded);
}

Task<Result<void>> SchemeAgent::run() {
  std::optional<Loaded> next = look_for_another();
  if (!next) next = without_program();
  while (true) {
    Loaded loaded = std::move(*next);
    Result<std::optional<Loaded>> another = co_await live(std::move(loaded));
    if (!another) co_return fail(another);
    next = std::move(*another);
  }
}

Task<Result<void>> SchemeAgent::say_state(LeaseId lease) {
  Transaction state;
  const Datum name = Datum::symbol(context_.name);
  const Datum how = refused_.empty() ? "runs"_sym : has_program_ ? "kept"_sym : "broken"_sym;
  state.tell(list("program"_sym, name, how, refused_), {}, lease);
  const Result<Revision> told = co_await context_.board.transact(std::move(state));
  if (!told) co_return fail(told);
  co_return {};
}

// Under a lease of its own, so that what the program before told goes when nobody renews its lease.
Task<Result<void>> SchemeAgent::begin(Life& life, const Loaded& loaded) {
  life.running.reset();
  const Result<LeaseId> lease = co_await context_.board.lease(runtime::Presence::lease_length);
  if (!lease) co_return fail(lease);
  life.lease = *lease;
  life.renewed = context_.executor.now();
  life.runner =
      std::make_shared<PartRunner>(context_, life.caller, loaded.program, life.lease, allowance_, options_.log);
  const Result<void> said = co_await say_state(life.lease);
  if (!said) co_return said;
  const Result<void> introduced = co_await life.runner->introduce();
  if (!introduced) {
    options_.log(describe(introduced.error()));
    const bool passes = introduced.error().symbol == "unknown-lease";
    if (passes) co_return introduced;
  }
  life.running.emplace(context_, life.runner);
  co_return {};
}

// A board that has forgotten the lease is told everything again.
Task<Result<void>> SchemeAgent::keep_lease(Life& life, const Loaded& loaded) {
  const bool due = context_.executor.now() >= life.renewed + runtime::Presence::renewal;
  if (!due) co_return {};
  const Result<void> renewed = co_await context_.board.renew(life.lease);
  life.renewed = context_.executor.now();
  if (renewed) co_return {};
  if (renewed.error().symbol != "unknown-lease") co_return {};
  co_return co_await begin(life, loaded);
}

// Until a program with another contract has loaded, which it answers.
Task<Result<std::optional<SchemeAgent::Loaded>>> SchemeAgent::live(Loaded loaded) {
  Life life(context_, loaded.contract);
  const Result<void> started = co_await life.service.start();
  if (!started) co_return fail(started);
  Result<void> begun = co_await begin(life, loaded);
  runtime::Handler handler = [&life](Datum operation) { return RunningProgram::answer(life.runner, operation); };
  life.serving = context_.executor.spawn([](Life& served, runtime::Handler answer) -> Task<void> {
    served.ended = co_await served.service.serve(std::move(answer));
  }(life, std::move(handler)));
  while (true) {
    co_await sleep(context_.executor, look_pause);
    if (life.ended) co_return fail(*life.ended);
    if (life.runner->broken()) co_return fail(*life.runner->broken());
    const std::string refused_before = refused_;
    std::optional<Loaded> another = look_for_another();
    if (another) {
      const bool same = another->contract.form == loaded.contract.form;
      if (!same) {
        life.running.reset();
        const Result<void> left = co_await life.service.leave(patience_when_leaving);
        co_return another;
      }
      loaded = std::move(*another);
      begun = co_await begin(life, loaded);
    } else if (refused_ != refused_before) {
      const Result<void> said = co_await say_state(life.lease);
    }
    if (begun) {
      begun = co_await keep_lease(life, loaded);
    } else {
      begun = co_await begin(life, loaded);
    }
  }
}

}  // namespace pizarra::scheme
