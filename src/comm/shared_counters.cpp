#include "comm/shared_counters.h"

#include <array>
#include <chrono>
#include <thread>

namespace repose {
namespace {

constexpr int question_tag = 0;
constexpr int sum_tag = 0;  ///< of the reply to add(); those to recent() have 1 and on

/// Counter, what to add, tag of the reply.
using Question = std::array<std::int64_t, 3>;

bool is_done(MPI_Request& request) {
  int done = 0;
  check_mpi(MPI_Test(&request, &done, MPI_STATUS_IGNORE), "MPI_Test");
  return done != 0;
}

}  // namespace

SharedCounters::SharedCounters(const Communicator& comm, int count)
    : comm_(comm, 0), values_(static_cast<std::size_t>(count)), recent_(static_cast<std::size_t>(count)) {}

SharedCounters::~SharedCounters() {
  const std::int64_t asked = comm_.sum(asked_);
  while (comm_.is_root() && answered_ < asked) answer();
  for (Recent& r : recent_) MPI_Wait(&r.reply, MPI_STATUS_IGNORE);
}

MPI_Request SharedCounters::ask(int which, std::int64_t value, int reply_tag, std::int64_t& before) {
  MPI_Request reply = MPI_REQUEST_NULL;
  check_mpi(MPI_Irecv(&before, 1, MPI_INT64_T, 0, reply_tag, comm_.handle(), &reply), "MPI_Irecv");
  const Question question = {which, value, reply_tag};
  check_mpi(MPI_Send(question.data(), static_cast<int>(question.size()), MPI_INT64_T, 0, question_tag, comm_.handle()),
            "MPI_Send");
  ++asked_;
  return reply;
}

std::int64_t SharedCounters::add(int which, std::int64_t value) {
  std::int64_t before = 0;
  if (comm_.is_root()) {
    before = values_[static_cast<std::size_t>(which)];
    values_[static_cast<std::size_t>(which)] += value;
    return before;
  }
  MPI_Request reply = ask(which, value, sum_tag, before);
  while (!is_done(reply)) std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the core may be another's
  return before;
}

std::int64_t SharedCounters::recent(int which) {
  if (comm_.is_root()) return read(which);
  Recent& r = recent_[static_cast<std::size_t>(which)];
  if (is_done(r.reply)) {  // also when nothing has been asked yet
    r.value = r.next;
    r.reply = ask(which, 0, 1 + which, r.next);
  }
  return r.value;
}

void SharedCounters::answer() {
  while (true) {
    int found = 0;
    MPI_Status status;
    check_mpi(MPI_Iprobe(MPI_ANY_SOURCE, question_tag, comm_.handle(), &found, &status), "MPI_Iprobe");
    if (found == 0) return;
    Question question;
    check_mpi(MPI_Recv(question.data(), static_cast<int>(question.size()), MPI_INT64_T, status.MPI_SOURCE, question_tag,
                       comm_.handle(), MPI_STATUS_IGNORE),
              "MPI_Recv");
    const std::int64_t before = add(static_cast<int>(question[0]), question[1]);
    check_mpi(MPI_Send(&before, 1, MPI_INT64_T, status.MPI_SOURCE, static_cast<int>(question[2]), comm_.handle()),
              "MPI_Send");
    ++answered_;
  }
}

}  // namespace repose
