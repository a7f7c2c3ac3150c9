#include "agents/console/session.hpp"

#include <fmt/format.h>
#include <vector>

#include "agents/console/agent_requests.hpp"
#include "agents/console/arm_claims.hpp"
#include "agents/console/held_jog.hpp"
#include "agents/console/numbered_requests.hpp"
#include "agents/console/page_arms.hpp"
#include "agents/console/page_beat.hpp"
#include "agents/console/page_hello.hpp"
#include "agents/console/page_images.hpp"
#include "agents/console/page_instruments.hpp"
#include "agents/console/page_pictures.hpp"
#include "agents/console/page_questions.hpp"
#include "agents/console/page_stops.hpp"
#include "lisp/reader.hpp"

namespace pizarra::console {

namespace {

constexpr Duration longest_farewell = 1s;
constexpr ReadLimits message_limits{.bytes = web::WebSocket::max_message, .depth = 32, .elements = 4000};

}  // namespace

// What a page has under way. All of it ends when the page leaves.
struct Session::Parts {
  explicit Parts(Session& page)
      : beat(page.board_, page.voice_),
        requests(page.setup_.executor, page.voice_),
        images(page.setup_.executor, page.setup_.images, beat.pulse(),
               [&page](const Datum& form) { return page.hear_on_lane(form); }),
        pictures(page.board_, page.voice_, requests, images, page.setup_.pictures),
        arms(page.board_, page.voice_, page.setup_.cell),
        questions(page.board_, page.voice_, requests, arms),
        agents(page.board_, page.voice_, requests),
        claims(page.board_, requests),
        stops(page.board_, page.voice_),
        jog(page.board_, page.voice_, requests, beat.pulse()),
        instruments({page.setup_.executor, page.board_.facts(), page.board_.name(), page.setup_.key, page.setup_.truth,
                     page.setup_.kept, page.setup_.instruments, page.setup_.connect},
                    page.voice_) {}

  PageBeat beat;
  NumberedRequests requests;
  PageImages images;
  PagePictures pictures;
  PageArms arms;
  PageQuestions questions;
  AgentRequests agents;
  ArmClaims claims;
  PageStops stops;
  HeldJog jog;
  PageInstruments instruments;
};

// What a page may say: each needs its elements and more of these kinds.
struct Session::Verb {
  using Run = std::function<void(Session&, const Datum& form)>;
  std::string_view name;
  std::vector<Datum::Kind> takes;
  Run run;
  bool goes_two_ways = false;  // over a lane as well

  bool fits(const Datum& form) const {
    if (form.size() != takes.size() + 1) return false;
    for (std::size_t i = 0; i < takes.size(); ++i) {
      if (form[i + 1].kind() != takes[i]) return false;
    }
    return true;
  }

  // The part of the page that does it.
  template <typename Part>
  static Run by(Part Parts::*part, void (Part::*does)(const Datum&)) {
    return [part, does](Session& page, const Datum& form) { (((*page.parts_).*part).*does)(form); };
  }
  static Run truth(bool looks) {
    return [looks](Session& page, const Datum&) { page.parts_->instruments.show_truth(looks); };
  }
  static Run activity(bool looks) {
    return [looks](Session& page, const Datum&) { page.parts_->instruments.show_activity(looks); };
  }
  static void work(Session& page, const Datum& form) {
    page.parts_->requests.begin(form[1].integer(), page.parts_->instruments.tell_work(form[1].integer()));
  }
  static void method(Session& page, const Datum& form) {
    page.parts_->instruments.look_at_method(form[1].integer(), form[2].integer());
  }
  static void cells(Session& page, const Datum& form) { page.parts_->instruments.look_at_cells(form[1].integer()); }
  static void heard(Session& page, const Datum& form) {
    if (!page.voice_.heard(form[1].integer())) page.voice_.close(1008, "not understood");
  }

  static std::span<const Verb> all();
};

std::span<const Session::Verb> Session::Verb::all() {
  constexpr auto number = Datum::Kind::integer;
  constexpr auto name = Datum::Kind::symbol;
  constexpr auto text = Datum::Kind::string;
  constexpr auto form = Datum::Kind::list;
  static const std::vector<Verb> verbs = {
      {"follow", {number, form}, by(&Parts::questions, &PageQuestions::follow)},
      {"watch", {number, text}, by(&Parts::questions, &PageQuestions::watch)},
      {"unwatch", {number}, by(&Parts::questions, &PageQuestions::unwatch)},
      {"ask", {number, form}, by(&Parts::questions, &PageQuestions::ask)},
      {"then", {number, form, number}, by(&Parts::questions, &PageQuestions::then)},
      {"picture", {number, name, number}, by(&Parts::pictures, &PagePictures::picture)},
      {"request", {number, name, form}, by(&Parts::agents, &AgentRequests::request)},
      {"goal", {number, text}, by(&Parts::agents, &AgentRequests::goal)},
      {"stop", {number, text}, by(&Parts::stops, &PageStops::stop), true},
      {"clear-stops", {number}, by(&Parts::claims, &ArmClaims::clear_stops)},
      {"command", {number, name}, by(&Parts::claims, &ArmClaims::command)},
      {"take-over", {number, name}, by(&Parts::claims, &ArmClaims::take_over)},
      {"let-go", {number, name}, by(&Parts::claims, &ArmClaims::let_go)},
      {"ask-for", {number, name}, by(&Parts::claims, &ArmClaims::ask_for)},
      {"ask-no-more", {number, name}, by(&Parts::claims, &ArmClaims::ask_no_more)},
      {"stamp", {number}, by(&Parts::beat, &PageBeat::stamp)},
      {"jog", {number, name, name, number}, by(&Parts::jog, &HeldJog::jog), true},
      {"hold-on", {number, number}, by(&Parts::jog, &HeldJog::hold_on), true},
      {"release", {number}, by(&Parts::jog, &HeldJog::release), true},
      {"truth", {}, truth(true)},
      {"truth-no-more", {}, truth(false)},
      {"activity", {}, activity(true)},
      {"activity-no-more", {}, activity(false)},
      {"work", {number}, work},
      {"method", {number, number}, method},
      {"cells", {number}, cells},
      {"look", {name}, by(&Parts::pictures, &PagePictures::look)},
      {"look-away", {name}, by(&Parts::pictures, &PagePictures::look_away)},
      {"heard", {number}, heard}};
  return verbs;
}

Session::Session(Setup setup, web::UpgradedSocket socket)
    : setup_(std::move(setup)),
      board_(setup_.executor, setup_.name, std::move(setup_.board)),
      voice_(setup_.executor, std::move(socket),
             {.text = [this](std::string_view message) { hear(message); }, .ended = [this] { leave(); }}),
      parts_(std::make_unique<Parts>(*this)) {
  opening_ = setup_.executor.spawn(open());
  running_out_ = setup_.executor.spawn(run_out());
}

Session::~Session() { setup_.executor.cancel(going_timer_); }

bool Session::takes_lane() const { return parts_ != nullptr && parts_->images.takes_lane(); }

void Session::add_lane(web::UpgradedSocket socket) {
  if (takes_lane()) parts_->images.add_lane(std::move(socket));
}

void Session::leave() {
  if (parts_ == nullptr) return;
  opening_ = Job();
  running_out_ = Job();
  parts_.reset();
  closing_ = setup_.executor.spawn(close_board());
}

void Session::dismiss(std::string_view why) {
  if (going_timer_ != 0) return;
  voice_.close(1008, why);
  going_timer_ = setup_.executor.call_at(setup_.executor.now() + longest_farewell, [this] { leave(); });
}

Task<void> Session::close_board() {
  co_await board_.leave();
  setup_.executor.post(setup_.ended);
}

Task<void> Session::open() {
  const Result<void> present = co_await board_.start();
  if (!present) {
    const bool barred = present.error().symbol == "not-permitted";
    const std::string what = barred ? "your key may not open a page" : "the board refuses this page";
    voice_.close(1011, fmt::format("{} ({})", what, present.error().sentence));
    co_return;
  }
  co_await parts_->claims.declare();
  PageRights rights = co_await rights_of(board_.facts());
  const bool truth = parts_->instruments.may_see_truth();
  voice_.say(hello_text(setup_.cell, {setup_.page_version, setup_.number, board_.name(), std::move(rights), truth}));
  parts_->beat.start();
}

Task<void> Session::run_out() {
  const Duration left = setup_.until - setup_.executor.now();
  co_await sleep(setup_.executor, left);
  dismiss("the session is over");
}

void Session::hear(std::string_view message) {
  if (parts_ == nullptr) return;
  const Result<Datum> form = read_one(message, message_limits);
  if (form) {
    for (const Verb& verb : Verb::all()) {
      if (form->is_form(verb.name) && verb.fits(*form)) return verb.run(*this, *form);
    }
  }
  // No page of ours says it.
  voice_.close(1008, "not understood");
}

// A lane brings the words that move the arm and stop it as well: a packet that is lost, or a line that is dead, on one
// way does not hold them back.
bool Session::hear_on_lane(const Datum& form) {
  for (const Verb& verb : Verb::all()) {
    if (!verb.goes_two_ways || !form.is_form(verb.name) || !verb.fits(form)) continue;
    verb.run(*this, form);
    return true;
  }
  return false;
}

}  // namespace pizarra::console
