#include "programs/commands/calibration_news.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <unistd.h>

#include "blackboard/client/keyed_board.hpp"

namespace pizarra::programs {
namespace {

const Datum any = "?"_sym;

constexpr const char* contract_text = R"((contract calibrate
  (posts
    (relation calibration
      ((state symbol) (sentence string) (width integer) (height integer) (boards integer) (wanted integer)) (key))
    (relation calibration-sees ((outlines list) (sentence string)) (key))
    (relation calibration-board ((number integer) (outlines list)) (key number))
    (relation calibration-lacks ((sentence string) (part list)) (key sentence)))))";

Datum part_of(const camera::Lack& lack) {
  if (!lack.part) return Datum();
  return list(lack.part->right_image ? 1 : 0, lack.part->column, lack.part->row);
}

using FourCorners = std::array<cv::Point2f, 4>;

// Of a part of the board the smallest rectangle around its corners.
FourCorners four_around(const std::vector<cv::Point2f>& corners, const camera::CalibrationBoard& board) {
  const auto all = static_cast<std::size_t>(board.columns) * static_cast<std::size_t>(board.rows);
  FourCorners out;
  if (corners.size() < all) {
    cv::minAreaRect(corners).points(out.data());
    return out;
  }
  const auto row = static_cast<std::size_t>(board.columns - 1);
  return {corners[0], corners[row], corners[all - 1], corners[all - 1 - row]};
}

Datum outline_of(const std::vector<cv::Point2f>& corners, const camera::CalibrationBoard& board) {
  std::vector<Datum> out;
  for (const cv::Point2f& corner : four_around(corners, board)) {
    out.push_back(to_datum(cvRound(corner.x)));
    out.push_back(to_datum(cvRound(corner.y)));
  }
  return Datum::list(std::move(out));
}

}  // namespace

CalibrationNews::Outlines CalibrationNews::outlines_of(const camera::BoardView& view,
                                                       const camera::CalibrationBoard& board) {
  if (view.right.empty()) return list(outline_of(view.left, board));
  return list(outline_of(view.left, board), outline_of(view.right, board));
}

Result<std::unique_ptr<CalibrationNews>> CalibrationNews::open(const std::string& address, const std::string& key) {
  std::unique_ptr<CalibrationNews> news(new CalibrationNews);
  const std::string name = fmt::format("calibrate-{}", getpid());
  auto board = client::keyed_board(news->executor_, address, key, name);
  if (!board) return fail(board);
  news->board_ = std::move(*board);
  news->context_.emplace(name, "localhost", news->executor_, *news->board_, Random(1));
  news->service_.emplace(*news->context_, runtime::contract_from_text(contract_text).value());
  const Job begun = news->executor_.spawn(news->begin());
  news->executor_.run_until([&begun] { return begun.done(); });
  if (!news->told_) return fail(news->told_);
  news->telling_ = news->executor_.spawn(news->tell_newest());
  news->thread_ = std::jthread([&all = *news] { all.executor_.run_until([&all] { return all.telling_.done(); }); });
  return news;
}

CalibrationNews::~CalibrationNews() { [[maybe_unused]] const Result<void> told = finish(); }

Task<void> CalibrationNews::begin() {
  // Nothing, which any board answers, if it is there: an agent would wait for it.
  const std::vector<Relation> nothing;
  told_ = co_await board_->declare(nothing);
  if (!told_) co_return;
  told_ = co_await service_->start();
  if (!told_) co_return;
  Transaction anew;
  anew.retract(list("calibration"_sym, any, any, any, any, any, any));
  anew.retract(list("calibration-sees"_sym, any, any));
  anew.retract(list("calibration-board"_sym, any, any));
  anew.retract(list("calibration-lacks"_sym, any, any));
  const Result<Revision> changed = co_await board_->transact(std::move(anew));
  if (!changed) told_ = fail(changed);
}

void CalibrationNews::tell(News news) {
  {
    const std::scoped_lock lock(mutex_);
    newest_ = std::move(news);
  }
  executor_.post([this] { turn_.set(); });
}

Result<void> CalibrationNews::finish() {
  if (!thread_.joinable()) return told_;
  {
    const std::scoped_lock lock(mutex_);
    finishing_ = true;
  }
  executor_.post([this] { turn_.set(); });
  thread_.join();
  return told_;
}

// Nothing comes any more where it ends.
Task<void> CalibrationNews::tell_newest() {
  while (told_) {
    turn_.reset();
    const std::optional<News> news = newest();
    if (!news) {
      const bool over = is_over();
      if (over) break;
      co_await turn_.wait();
      continue;
    }
    const Result<Revision> changed = co_await board_->transact(step_to(*news));
    if (!changed) told_ = fail(changed);
  }
  // Where the board is lost its lease lapses.
  if (!told_) co_return;
  [[maybe_unused]] const Result<void> left = co_await service_->leave(0s);
}

std::optional<CalibrationNews::News> CalibrationNews::newest() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(newest_, std::nullopt);
}

bool CalibrationNews::is_over() {
  const std::scoped_lock lock(mutex_);
  return finishing_ && !newest_;
}

Transaction CalibrationNews::step_to(const News& news) {
  Transaction step;
  for (; boards_told_ < news.taken.size(); ++boards_told_) {
    step.tell(list("calibration-board"_sym, boards_told_ + 1, news.taken[boards_told_]));
  }
  std::vector<std::string> lacks;
  for (const camera::Lack& lack : news.lacks) lacks.push_back(lack.sentence);
  if (lacks != lacks_told_) {
    step.retract(list("calibration-lacks"_sym, any, any));
    for (const camera::Lack& lack : news.lacks) step.tell(list("calibration-lacks"_sym, lack.sentence, part_of(lack)));
    lacks_told_ = std::move(lacks);
  }
  step.tell(list("calibration-sees"_sym, news.seen, news.seen_sentence));
  step.tell(list("calibration"_sym, Datum::symbol(news.state), news.sentence, news.image.width, news.image.height,
                 news.taken.size(), news.wanted));
  return step;
}

}  // namespace pizarra::programs
