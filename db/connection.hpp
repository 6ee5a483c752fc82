#pragma once
// What stands behind a Store: one connection that writes, and a few that read at the same time. In
// WAL readers and the writer do not wait for each other. Private to db/.

#include <memory>
#include <mutex>
#include <vector>

#include "db/database.hpp"
#include "db/store.hpp"
#include "db/turns.hpp"

namespace leda::db {

class Store::Connection {
 public:
  Connection(std::filesystem::path file, std::chrono::milliseconds busy_timeout)
      : file_(std::move(file)), busy_timeout_(busy_timeout), writer_(file_, busy_timeout) {}

  /// For what is done while nobody else uses the store, and for write() of free functions.
  Database& writer() { return writer_; }

  /// One transaction that may change things. Threads take turns.
  template <class Work>
  auto write(Work work) {
    return writer_.write([&] { return work(writer_); });
  }

  /// One unchanging view of the data, with every transaction that was answered before it. `work`
  /// must not ask the store again: it might wait for itself.
  template <class Work>
  auto read(Work work) {
    const Turns::Turn turn(turns_);
    const Lease reader(*this);
    return reader->read([&] { return work(*reader); });
  }

 private:
  /// Reading is work for a core. A reader that is opened for a single question costs more than the
  /// answer.
  static constexpr std::uint64_t most_readers = 8;

  /// A reader that is nobody else's meanwhile.
  class Lease {
   public:
    explicit Lease(Connection& owner) : owner_(owner), reader_(owner.borrow()) {}
    ~Lease() { owner_.give_back(std::move(reader_)); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    Database* operator->() const { return reader_.get(); }
    Database& operator*() const { return *reader_; }

   private:
    Connection& owner_;
    std::unique_ptr<Database> reader_;
  };

  std::unique_ptr<Database> borrow() {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        auto reader = std::move(idle_.back());
        idle_.pop_back();
        return reader;
      }
    }
    return std::make_unique<Database>(file_, busy_timeout_, Database::Access::read);
  }

  void give_back(std::unique_ptr<Database> reader) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(reader));
  }

  std::filesystem::path file_;
  std::chrono::milliseconds busy_timeout_;
  Database writer_;
  Turns turns_{most_readers};
  std::mutex mutex_;  ///< guards idle_
  std::vector<std::unique_ptr<Database>> idle_;
};

}  // namespace leda::db
