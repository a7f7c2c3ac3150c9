#include "agents/console/session.hpp"

#include <fmt/format.h>

#include "agents/console/change_text.hpp"
#include "agents/console/console_contract.hpp"
#include "agents/console/page_rights.hpp"
#include "lisp/reader.hpp"

namespace pizarra::console {

namespace {

constexpr Duration longest_farewell = 1s;
constexpr ReadLimits message_limits{.bytes = WebSocket::max_message, .depth = 32, .elements = 4000};

std::string reach_text(const ReachOutline& reach) {
  std::string parts;
  for (const ReachOutline::Part& reached : reach.parts) {
    parts += fmt::format("{}[{:.0f},{:.0f}]", parts.empty() ? "" : ",", reached.from_mm, reached.to_mm);
  }
  return fmt::format("{{\"height\":{:.1f},\"parts\":[{}]}}", reach.height_mm, parts);
}

// Each axis by its name and the unit of its readings.
std::string axes_text(const arm::ArmModel& model) {
  std::string axes;
  for (const arm::Axis& axis : model.axes) {
    const std::string_view unit = arm::slides(axis.role) ? "mm" : "°";
    axes += fmt::format("{}[\"{}\",\"{}\"]", axes.empty() ? "" : ",", arm::role_name(axis.role), unit);
  }
  return axes;
}

std::string refused_text(const PageRights& rights) {
  std::string items;
  for (const auto& [word, why] : rights.refused()) {
    items += fmt::format("{}{}:{}", items.empty() ? "" : ",", json_string(word), json_string(why));
  }
  return items;
}

// `truth`: whether there is any to lay over what is believed.
std::string hello_text(const Session::Setup& setup, const PageRights& rights, bool truth) {
  const CellView& cell = setup.cell;
  std::string arms;
  std::string axes;
  for (const auto& [arm, model] : cell.arms) {
    arms += (arms.empty() ? "" : ",") + json_string(arm);
    axes += fmt::format("{}{}:[{}]", axes.empty() ? "" : ",", json_string(arm), axes_text(model));
  }
  std::string reaches;
  for (const auto& [arm, reach] : cell.reaches) {
    reaches += fmt::format("{}{}:{}", reaches.empty() ? "" : ",", json_string(arm), reach_text(reach));
  }
  std::string camera = "null";
  if (cell.camera) {
    const forms::CameraPose& at = *cell.camera;
    camera = fmt::format("{{\"at\":[{:.2f},{:.2f},{:.2f}],\"pan\":{:.3f},\"tilt\":{:.3f},\"roll\":{:.3f},\"head\":{}}}",
                         at.at_mm[0], at.at_mm[1], at.at_mm[2], at.pan_deg, at.tilt_deg, at.roll_deg, cell.head);
  }
  return fmt::format(
      "{{\"hello\":{{\"version\":{},\"name\":{},\"cell\":{},\"arms\":[{}],\"axes\":{{{}}},\"reaches\":{{{}}},"
      "\"camera\":{},\"cube\":{:.1f},\"truth\":{},\"mayNot\":{{{}}},"
      "\"images\":{{\"path\":\"/socket/{}\",\"lanes\":{}}}}}}}",
      json_string(setup.page_version), json_string(setup.name), json_string(cell.name), arms, axes, reaches, camera,
      cell.cube_mm, truth, refused_text(rights), setup.number, PageImages::max_lanes);
}

}  // namespace

// What a page may say: each needs its elements and more of these kinds.
struct Session::Verb {
  std::string_view name;
  std::vector<Datum::Kind> takes;
  std::function<void(Session&, const Datum& form)> run;
  bool goes_two_ways = false;  // over a lane as well

  bool fits(const Datum& form) const {
    if (form.size() != takes.size() + 1) return false;
    for (std::size_t i = 0; i < takes.size(); ++i) {
      if (form[i + 1].kind() != takes[i]) return false;
    }
    return true;
  }
  static std::span<const Verb> all();
};

std::span<const Session::Verb> Session::Verb::all() {
  constexpr auto number = Datum::Kind::integer;
  constexpr auto name = Datum::Kind::symbol;
  constexpr auto text = Datum::Kind::string;
  constexpr auto form = Datum::Kind::list;
  static const std::vector<Verb> verbs = {
      {"follow", {number, form}, &Session::follow},
      {"watch", {number, text}, &Session::watch},
      {"unwatch", {number}, &Session::unwatch},
      {"ask", {number, form}, &Session::ask},
      {"then", {number, form, number}, &Session::then},
      {"picture", {number, name, number}, &Session::picture},
      {"request", {number, name, form}, &Session::request},
      {"goal", {number, text}, &Session::goal},
      {"stop", {number, text}, &Session::stop, true},
      {"clear-stops", {number}, &Session::clear_stops},
      {"command", {number, name}, &Session::command},
      {"take-over", {number, name}, &Session::take_over},
      {"let-go", {number, name}, &Session::let_go},
      {"ask-for", {number, name}, &Session::ask_for},
      {"ask-no-more", {number, name}, &Session::ask_no_more},
      {"stamp", {number}, &Session::stamp},
      {"jog", {number, name, name, number}, &Session::jog, true},
      {"hold-on", {number, number}, &Session::hold_on, true},
      {"release", {number}, &Session::release, true},
      {"truth", {}, [](Session& page, const Datum&) { page.instruments_->show_truth(true); }},
      {"truth-no-more", {}, [](Session& page, const Datum&) { page.instruments_->show_truth(false); }},
      {"activity", {}, [](Session& page, const Datum&) { page.instruments_->show_activity(true); }},
      {"activity-no-more", {}, [](Session& page, const Datum&) { page.instruments_->show_activity(false); }},
      {"work",
       {number},
       [](Session& page, const Datum& said) {
         page.begin_request(said[1].integer(), page.instruments_->tell_work(said[1].integer()));
       }},
      {"method",
       {number, number},
       [](Session& page, const Datum& said) {
         page.instruments_->look_at_method(said[1].integer(), said[2].integer());
       }},
      {"cells",
       {number},
       [](Session& page, const Datum& said) { page.instruments_->look_at_cells(said[1].integer()); }},
      {"look", {name}, &Session::look},
      {"look-away", {name}, &Session::look_away},
      {"heard", {number}, &Session::heard}};
  return verbs;
}

Session::Session(Setup setup, UpgradedSocket socket)
    : setup_(std::move(setup)),
      context_{setup_.name, "localhost", setup_.executor, *setup_.board, Random(1)},
      service_(
          context_,
          runtime::contract_from_text(fmt::format("(contract console {} {})", posts_of_pages, reads_of_pages)).value()),
      caller_(context_, service_),
      hands_changed_(setup_.executor),
      images_(std::make_unique<PageImages>(setup_.executor, setup_.images, pulse_,
                                           [this](const Datum& form) { return hear_on_lane(form); })),
      voice_(setup_.executor, std::move(socket),
             {.text = [this](std::string_view message) { hear(message); }, .ended = [this] { leave(); }}),
      instruments_(std::make_unique<PageInstruments>(
          PageInstruments::Setup{setup_.executor, *setup_.board, setup_.name, setup_.key, setup_.truth, setup_.kept,
                                 setup_.instruments, setup_.connect},
          voice_)) {
  opening_ = setup_.executor.spawn(open());
  running_out_ = setup_.executor.spawn(run_out());
  arms_ = setup_.executor.spawn(follow_arms());
  hands_ = setup_.executor.spawn(follow_hands());
}

Session::~Session() { setup_.executor.cancel(going_timer_); }

void Session::add_lane(UpgradedSocket socket) {
  if (takes_lane()) images_->add_lane(std::move(socket));
}

void Session::leave() {
  if (leaving_) return;
  leaving_ = true;
  opening_ = Job();
  running_out_ = Job();
  arms_ = Job();
  instruments_.reset();
  beating_ = Job();
  hands_ = Job();
  holding_ = Job();
  letting_go_ = Job();
  looks_.clear();
  watches_.clear();
  requests_.clear();
  images_.reset();
  closing_ = setup_.executor.spawn(close_board());
}

void Session::dismiss(std::string_view why) {
  if (going_timer_ != 0) return;
  voice_.close(1008, why);
  going_timer_ = setup_.executor.call_at(setup_.executor.now() + longest_farewell, [this] { leave(); });
}

// Its presence, and what stands under it, goes at once; where the board is away, its lease lapses.
Task<void> Session::close_board() {
  if (service_.presence() != 0) co_await say_goodbye();
  setup_.executor.post(setup_.ended);
}

Task<void> Session::say_goodbye() { [[maybe_unused]] const Result<void> left = co_await service_.leave(0s); }

Task<void> Session::open() {
  const Result<void> present = co_await service_.start();
  if (!present) {
    const bool barred = present.error().symbol == "not-permitted";
    const std::string what = barred ? "your key may not open a page" : "the board refuses this page";
    voice_.close(1011, fmt::format("{} ({})", what, present.error().sentence));
    co_return;
  }
  co_await declare_wishes();
  const PageRights rights = co_await rights_of(context_.board);
  voice_.say(hello_text(setup_, rights, instruments_->may_see_truth()));
  beating_ = setup_.executor.spawn(keep_beating());
}

Task<void> Session::run_out() {
  const Duration left = setup_.until - setup_.executor.now();
  co_await sleep(setup_.executor, left);
  dismiss("the session is over");
}

void Session::hear(std::string_view message) {
  if (leaving_) return;
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
