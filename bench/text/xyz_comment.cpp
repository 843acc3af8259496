// SPDX-License-Identifier: MIT
#include "bench/text/xyz_comment.h"

#include <algorithm>
#include <cctype>

#include "bench/text/fields.h"

namespace spherepair {
namespace {

constexpr std::string_view blank = " \t", not_in_words = " \t=\",}{][\\";

class CommentParser {
 public:
  explicit CommentParser(std::string_view text) : text_(text) {}

  std::vector<CommentPair> parse() {
    std::vector<CommentPair> pairs;
    for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
      CommentPair pair;
      if (!take_string(pair.key, pair.complete)) {
        ++at_;
        continue;
      }
      take_value(pair);
      pairs.push_back(pair);
    }
    return pairs;
  }

 private:
  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(blank, at_), text_.size()); }

  void take_value(CommentPair& pair) {
    const size_t before = at_;
    skip_blanks();
    if (here() != '=') {
      at_ = before;
      return;
    }
    ++at_;
    skip_blanks();
    pair.value.emplace();
    if (here() == '[' || here() == '{')
      take_brackets(*pair.value, pair.complete);
    else if (!take_string(*pair.value, pair.complete))
      pair.complete = false;
  }

  // Reads a string; false if none begins here.
  bool take_string(std::string& value, bool& complete) {
    if (here() == '"') {
      complete = take_quoted(value) && complete;
      return true;
    }
    if (here() == '\'' && take_single_quoted(value)) return true;
    const size_t start = at_;
    for (; at_ < text_.size(); ++at_) {
      const bool escape =
          text_[at_] == '\\' && at_ + 1 < text_.size() && not_in_words.find(text_[at_ + 1]) != blank.npos;
      if (escape) ++at_;
      if (!escape && not_in_words.find(text_[at_]) != blank.npos) break;
      value += text_[at_];
    }
    return at_ > start;
  }

  bool take_quoted(std::string& value) {
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') return ++at_, true;
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) {
        ++at_;
        value += text_[at_] == 'n' ? '\n' : text_[at_];
      } else {
        value += text_[at_];
      }
    }
    return false;
  }

  // Reads a string in single quotes, which programs write although the grammar has none. An apostrophe without another
  // is part of a word.
  bool take_single_quoted(std::string& value) {
    const size_t end = text_.find('\'', at_ + 1);
    if (end == text_.npos) return false;
    value = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return true;
  }

  // Reads an array, which may hold arrays or strings in quotes, up to its closing bracket.
  void take_brackets(std::string& value, bool& complete) {
    const size_t start = at_ + 1;
    const char open = here(), close = open == '[' ? ']' : '}';
    size_t depth = 0;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') {
        std::string skipped;
        if (!take_quoted(skipped)) break;
        --at_;
      }
      depth += text_[at_] == open;
      if (text_[at_] == close && --depth == 0) {
        value = text_.substr(start, at_++ - start);
        return;
      }
    }
    value = text_.substr(start);
    at_ = text_.size();
    complete = false;
  }

  std::string_view text_;
  size_t at_ = 0;
};

}  // namespace

std::vector<CommentPair> parse_comment(std::string_view comment) { return CommentParser(comment).parse(); }

std::optional<bool> parse_boolean(std::string_view text) {
  for (const char* word : {"T", "True", "true", "TRUE", "1"})
    if (text == word) return true;
  for (const char* word : {"F", "False", "false", "FALSE", "0"})
    if (text == word) return false;
  return std::nullopt;
}

bool mentions_box(std::string_view comment) {
  const std::string text = lower_case(comment);
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  for (auto start = text.begin(); start != text.end();) {
    start = std::find_if(start, text.end(), is_letter);
    const auto end = std::find_if_not(start, text.end(), is_letter);
    const std::string_view word(start, end);
    for (const std::string_view box : {"box", "cell"})
      if (word.starts_with(box) || word.ends_with(box)) return true;
    for (const std::string_view box : {"lattice", "periodic", "pbc"})
      if (word.find(box) != word.npos) return true;
    start = end;
  }
  return false;
}

}  // namespace spherepair
