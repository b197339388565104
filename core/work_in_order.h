/// Work on many items in threads of one process; what comes of them is handed on in their order.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

namespace wuerfel {

/// How many threads are meant: `asked`, or where that is 0 one for each core this process may use.
inline int thread_count(int asked) {
  if (asked > 0) return asked;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Who works, and who waits for it.
struct Workforce {
  int threads = 1;  ///< 1: the calling thread does everything
  /// Called ten times a second by the thread that waits for the others (before every item where
  /// nobody else works); what it throws ends the work.
  std::function<void()> pulse = {};
};

namespace internal {

/// One run of `work_in_order` with threads: `next` is asked by one thread at a time, `deliver` told
/// by one at a time, `work` done by many at once. At most `window` items are under way, so that a
/// slow one holds up the others before what they found fills the memory.
template <class Next, class Work, class Deliver>
class OrderedWork {
  using Item = typename std::invoke_result_t<Next&>::value_type;
  using Result = std::invoke_result_t<Work&, Item>;
  /// What came of an item: of the last one, why there are no more (null: there are none).
  using Outcome = std::variant<Result, std::exception_ptr>;

 public:
  OrderedWork(int threads, Next& next, Work& work, Deliver& deliver)
      : threads_(threads), next_(next), work_(work), deliver_(deliver) {}

  void run(const std::function<void()>& pulse) {
    std::vector<std::jthread> crew;
    crew.reserve(threads_);
    running_ = threads_;
    for (int i = 0; i < threads_; ++i)
      crew.emplace_back([this] { labour(); });
    std::exception_ptr broken_off = wait(pulse);
    crew.clear();
    if (broken_off == nullptr) broken_off = failure_;
    if (broken_off != nullptr) std::rethrow_exception(broken_off);
  }

 private:
  std::exception_ptr wait(const std::function<void()>& pulse) {
    constexpr std::chrono::milliseconds beat{100};
    std::unique_lock lock(state_);
    while (running_ > 0) {
      ended_.wait_for(lock, beat);
      if (!pulse) continue;
      lock.unlock();
      try {
        pulse();
      } catch (...) {
        stop();
        return std::current_exception();
      }
      lock.lock();
    }
    return nullptr;
  }

  void stop() {
    const std::lock_guard lock(state_);
    stopped_ = true;
    room_.notify_all();
  }

  void labour() {
    while (take_one()) {
    }
    const std::lock_guard lock(state_);
    --running_;
    ended_.notify_all();
  }

  bool take_one() {
    long number = 0;
    std::optional<Item> item;
    std::exception_ptr why;
    {
      const std::lock_guard input(input_);
      {
        std::unique_lock lock(state_);
        room_.wait(lock, [this] { return stopped_ || taken_ - delivered_ < window(); });
        if (stopped_ || exhausted_) return false;
      }
      number = taken_++;
      try {
        item = next_();
      } catch (...) {
        why = std::current_exception();
      }
      exhausted_ = !item.has_value();
    }
    hand_in(number, item ? outcome_of(std::move(*item)) : Outcome(why));
    return item.has_value();
  }

  Outcome outcome_of(Item item) {
    try {
      return work_(std::move(item));
    } catch (...) {
      return std::current_exception();
    }
  }

  // Whoever brings the one that is waited for delivers it, and those behind it.
  void hand_in(long number, Outcome outcome) {
    std::unique_lock lock(state_);
    waiting_.emplace(number, std::move(outcome));
    if (delivering_) return;
    delivering_ = true;
    for (auto first = waiting_.begin();
         !stopped_ && first != waiting_.end() && first->first == delivered_;
         first = waiting_.begin()) {
      Outcome ready = std::move(first->second);
      waiting_.erase(first);
      lock.unlock();
      const bool last = !delivered(std::move(ready));
      lock.lock();
      ++delivered_;
      stopped_ = stopped_ || last;
      room_.notify_all();
    }
    delivering_ = false;
  }

  bool delivered(Outcome outcome) {
    if (std::holds_alternative<std::exception_ptr>(outcome)) {
      failure_ = std::get<std::exception_ptr>(outcome);
      return false;
    }
    try {
      deliver_(std::move(std::get<Result>(outcome)));
    } catch (...) {
      failure_ = std::current_exception();
      return false;
    }
    return true;
  }

  [[nodiscard]] long window() const { return 64L * threads_; }

  int threads_;
  Next& next_;
  Work& work_;
  Deliver& deliver_;
  std::mutex input_;  // held while an item is fetched
  std::mutex state_;  // of all that follows
  // Apart, so that nobody is woken for nothing after every item.
  std::condition_variable room_;     // in the window
  std::condition_variable ended_;    // one of the crew
  std::map<long, Outcome> waiting_;  // by number, for those before them
  std::exception_ptr failure_;
  long taken_ = 0;
  long delivered_ = 0;
  int running_ = 0;
  bool exhausted_ = false;
  bool delivering_ = false;
  bool stopped_ = false;
};

}  // namespace internal

/// Fetches items from `next()` -> optional until it gives none, does `work(item)` -> result on each,
/// and hands what came of them to `deliver(result)`, in the order of the items whatever the number
/// of threads. An exception of any of the three ends the work once all before it is delivered, and
/// is thrown on.
template <class Next, class Work, class Deliver>
void work_in_order(const Workforce& workforce, Next next, Work work, Deliver deliver) {
  if (workforce.threads > 1) {
    internal::OrderedWork(workforce.threads, next, work, deliver).run(workforce.pulse);
    return;
  }
  while (auto item = next()) {
    if (workforce.pulse) workforce.pulse();
    deliver(work(std::move(*item)));
  }
}

/// work(i) of i = 0 .. count - 1, which may be called from several threads at once; results in
/// order.
template <class Work>
auto work_on_each(const Workforce& workforce, int count, Work work) {
  std::vector<std::invoke_result_t<Work&, int>> results;
  results.reserve(count);
  int i = 0;
  work_in_order(
      workforce, [&] { return i < count ? std::optional(i++) : std::nullopt; }, work,
      [&](auto result) { results.push_back(std::move(result)); });
  return results;
}

}  // namespace wuerfel
