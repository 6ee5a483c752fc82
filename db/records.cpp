#include "db/records.hpp"

#include <array>
#include <utility>

namespace leda::db {

namespace {

template <class State>
using Words = std::pair<State, const char*>;

// One table a type: the words stand in the store and in HTTP answers.
constexpr std::array<Words<JobState>, 5> job_states = {{{JobState::accepted, "accepted"},
                                                        {JobState::running, "running"},
                                                        {JobState::successful, "successful"},
                                                        {JobState::failed, "failed"},
                                                        {JobState::dismissed, "dismissed"}}};

constexpr std::array<Words<SectionState>, 7> section_states = {
    {{SectionState::waiting, "waiting"},
     {SectionState::running, "running"},
     {SectionState::finished, "finished"},
     {SectionState::left_out, "left_out"},
     {SectionState::stable, "stable"},
     {SectionState::failed, "failed"},
     {SectionState::dismissed, "dismissed"}}};

template <class Table, class State>
const char* word(const Table& table, State state) {
  for (const auto& [value, text] : table)
    if (value == state) return text;
  return "";
}

template <class State, class Table>
std::optional<State> value(const Table& table, const std::string& word) {
  for (const auto& [state, text] : table)
    if (word == text) return state;
  return std::nullopt;
}

}  // namespace

const char* to_string(JobState state) { return word(job_states, state); }

std::optional<JobState> job_state_from(const std::string& text) {
  return value<JobState>(job_states, text);
}

const char* to_string(SectionState state) { return word(section_states, state); }

std::optional<SectionState> section_state_from(const std::string& text) {
  return value<SectionState>(section_states, text);
}

}  // namespace leda::db
