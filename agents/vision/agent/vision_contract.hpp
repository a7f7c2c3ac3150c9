#pragma once

// The vision agent's contract: what it offers, posts, reads, lets you configure and monitor. Every fact begins with its
// name: several of its kind share a board.

#include <string_view>

namespace pizarra::vision {

inline constexpr std::string_view vision_contract = R"scheme(
(contract vision
  (offers
    (learn (x number) (y number) (name string))
    (learn (x number) (y number) (frame integer) (name string))
    (find (name string))
    (track (name string))
    (end-track)
    (get-objects)
    (connect)
    (disconnect)
    (keep)
    (accept (name string))
    (reject (name string))
    (forget (name string))
    (learn-from (other symbol))
    (rename (name string) (new-name string))
    (search-in (x number) (y number) (width number) (height number) (name string))
    (search-everywhere (name string))
    (look-at-most (times number) (name string))
    (look-always (name string))
    (define-body (marks list) (name string))
    (forget-body (name string)))
  (posts
    (relation vision-mode ((eyes symbol) (mode symbol) (connected symbol)) (key eyes))
    (relation vision-held ((eyes symbol) (client symbol) (mode symbol)) (key eyes client mode))
    (relation look ((eyes symbol) (frame integer) (text string) (of list)) (key eyes))
    (relation tracked ((eyes symbol) (name string) (state symbol) (frame integer) (confidence number))
                      (key eyes name))
    (relation found ((eyes symbol) (name string) (frame integer) (confidence number) (second string) (margin number)
                     (elsewhere list) (places list)) (key eyes name))
    (relation tags-seen ((eyes symbol) (frame integer) (captured integer) (tags list)) (key eyes))
    (relation vision-failed ((eyes symbol) (frame integer) (text string) (symbol symbol) (sentence string)) (key eyes))
    (relation learned ((eyes symbol) (name string) (num integer) (area number) (perimeter number) (features integer)
                       (m0 number) (m1 number) (m2 number)) (key eyes name num) (durable))
    (relation learned-template ((eyes symbol) (name string) (num integer) (tone symbol) (height number)
                                (slimness number) (roundness number) (roundness-spread number) (size number)
                                (by symbol) (picture string)) (key eyes name num) (durable))
    (relation learned-focal ((eyes symbol) (name string) (num integer) (focal number)) (key eyes name num) (durable))
    (relation learned-print ((eyes symbol) (name string) (num integer) (contrast number)) (key eyes name num) (durable))
    (relation learned-axis ((eyes symbol) (name string) (num integer) (degrees number)) (key eyes name num) (durable))
    (relation to-accept ((eyes symbol) (name string) (num integer)) (key eyes name num))
    (relation look-alike ((eyes symbol) (name string) (other string) (error number) (sentence string))
                         (key eyes name other))
    (relation objects-damaged ((eyes symbol) (file string) (symbol symbol) (sentence string)) (key eyes file))
    (relation body ((eyes symbol) (name string) (marks list)) (key eyes name) (durable))
    (relation searched-in ((eyes symbol) (name string) (x integer) (y integer) (width integer) (height integer))
                          (key eyes name))
    (relation looked-at-most ((eyes symbol) (name string) (times number)) (key eyes name))
    (relation camera-model ((eyes symbol) (width integer) (height integer) (focal number) (cx number) (cy number)
                            (base-line number)) (key eyes))
    (relation camera-state ((eyes symbol) (state symbol) (trouble string)) (key eyes))
    (relation camera-drops ((eyes symbol) (late integer) (skewed integer) (corrupt integer)) (key eyes))
    (relation stream ((name symbol) (kind symbol) (place list)) (key name)))
  (reads learned learned-template learned-focal learned-print learned-axis found body)
  (configures (learn learn-from accept reject forget rename connect disconnect keep search-in search-everywhere
               look-at-most look-always define-body forget-body))
  (monitors (vision-mode camera-state objects-damaged)))
)scheme";

}  // namespace pizarra::vision
