#include "agents/console/page_pictures.hpp"

#include <fmt/format.h>

#include "agents/console/change_text.hpp"
#include "agents/runtime/declared.hpp"

namespace pizarra::console {

namespace {

// A page that may read this fact may see the stream's images.
Datum fact_of_stream(const std::string& stream) {
  return list("stream"_sym, Datum::symbol(stream), "?kind"_sym, "?place"_sym);
}

}  // namespace

void PagePictures::look(const Datum& form) {
  const std::string stream(form[1].text());
  if (looks_.contains(stream)) return;
  if (looks_.size() >= PageImages::max_streams) return voice_.close(1008, "too many streams");
  looks_.emplace(stream, board_.executor().spawn(look_if_readable(stream)));
}

void PagePictures::look_away(const Datum& form) {
  const std::string stream(form[1].text());
  looks_.erase(stream);
  images_.look_away(stream);
}

Task<void> PagePictures::look_if_readable(std::string stream) {
  const Query query = query_for(fact_of_stream(stream));
  const Result<std::unique_ptr<Watch>> readable = co_await runtime::watch_when_declared(board_.facts(), query);
  if (readable) images_.look(stream);
}

void PagePictures::picture(const Datum& form) {
  const std::int64_t number = form[1].integer();
  if (kept_ == nullptr) return voice_.refuse(number, "no-picture", "this console keeps no pictures");
  requests_.begin(number, show_kept(number, std::string(form[2].text()), Time(Duration(form[3].integer()))));
}

Task<void> PagePictures::show_kept(std::int64_t number, std::string stream, Time moment) {
  const Result<std::vector<Fact>> readable = co_await board_.facts().facts(fact_of_stream(stream));
  if (!readable) {
    voice_.say(refusal_text(number, readable.error()));
    co_return;
  }
  const Result<PictureStore::Picture> kept = co_await kept_->find(std::move(stream), moment);
  if (!kept) {
    voice_.say(refusal_text(number, kept.error()));
    co_return;
  }
  co_await voice_.room();
  std::string message = fmt::format("(picture {} {} {} {} {})\n", number, kept->number,
                                    kept->captured.time_since_epoch().count(), kept->width, kept->height);
  voice_.show(message += kept->jpeg);
}

}  // namespace pizarra::console
