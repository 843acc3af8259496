// SPDX-License-Identifier: MIT
// Comments of extended XYZ against a second parser: it marks the characters within quotes and brackets first, and
// splits at those outside.
#include <vector>

#include "bench/text/xyz_comment.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

namespace {

constexpr std::string_view special = "=\",}{][\\", blank = " \t";
bool among(char c, std::string_view all) { return all.find(c) != all.npos; }

struct Token {
  char kind;  // w: a word or a string, a: an array, =, e: an error, which separates
  std::string text = {};
  bool complete = true;
  size_t start = 0, end = 0;
};

// Of "..." from its first character on, the text and the place behind it.
Token quoted(std::string_view text, size_t at) {
  Token token{'w', "", false, at, text.size()};
  for (size_t k = at + 1; k < text.size(); ++k) {
    if (text[k] == '"') {
      token.complete = true;
      token.end = k + 1;
      return token;
    }
    const bool escaped = text[k] == '\\' && k + 1 < text.size();
    if (escaped) ++k;
    token.text.push_back(escaped && text[k] == 'n' ? '\n' : text[k]);
  }
  return token;
}

Token word(std::string_view text, size_t at) {
  Token token{'w', "", true, at, at};
  while (token.end < text.size()) {
    const bool escaped = text[token.end] == '\\' && token.end + 1 < text.size() &&
                         (among(text[token.end + 1], special) || among(text[token.end + 1], blank));
    if (escaped)
      token.end += 1;
    else if (among(text[token.end], special) || among(text[token.end], blank))
      break;
    token.text.push_back(text[token.end++]);
  }
  return token;
}

// Brackets of the kind that opened it are counted; those in strings are not.
Token array(std::string_view text, size_t at) {
  const char open = text[at], close = open == '[' ? ']' : '}';
  int inside = 0;
  for (size_t k = at; k < text.size(); ++k) {
    if (text[k] == '"') {
      const Token string = quoted(text, k);
      if (!string.complete) break;
      k = string.end - 1;
    }
    inside += text[k] == open ? 1 : text[k] == close ? -1 : 0;
    if (inside == 0) return {'a', std::string(text.substr(at + 1, k - at - 1)), true, at, k + 1};
  }
  return {'a', std::string(text.substr(at + 1)), false, at, text.size()};
}

Token token_at(std::string_view text, size_t at, bool value) {
  const char c = text[at];
  if (c == '"') return quoted(text, at);
  const size_t closing = c == '\'' ? text.find('\'', at + 1) : text.npos;
  if (closing != text.npos) return {'w', std::string(text.substr(at + 1, closing - at - 1)), true, at, closing + 1};
  if (value && (c == '[' || c == '{')) return array(text, at);
  const Token found = word(text, at);
  return found.end > at ? found : Token{c == '=' ? '=' : 'e', "", true, at, at + 1};
}

std::vector<CommentPair> comment_by_words(std::string_view text) {
  std::vector<Token> tokens;
  for (size_t at = 0; at < text.size();) {
    if (among(text[at], blank)) {
      ++at;
      continue;
    }
    const bool value = tokens.size() > 1 && tokens.back().kind == '=' && tokens[tokens.size() - 2].kind == 'w';
    tokens.push_back(token_at(text, at, value));
    at = tokens.back().end;
    // What follows = is no key of another =.
    if (value && tokens.back().kind == 'w') tokens.back().kind = 'v';
  }
  std::vector<CommentPair> pairs;
  for (size_t k = 0; k < tokens.size(); ++k) {
    if (tokens[k].kind != 'w') continue;
    CommentPair pair{.key = tokens[k].text, .value = {}, .complete = tokens[k].complete};
    if (k + 1 < tokens.size() && tokens[k + 1].kind == '=') {
      const bool given = k + 2 < tokens.size() && among(tokens[k + 2].kind, "va");
      pair.value = given ? tokens[k + 2].text : "";
      pair.complete = pair.complete && given && tokens[k + 2].complete;
    }
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

FUZZ(comment) {
  const std::string_view text = text_of(data, size);
  const std::vector<CommentPair> read = parse_comment(text), again = comment_by_words(text);
  require(read.size() == again.size(), "two readings of a comment differ in the number of pairs");
  for (size_t k = 0; k < read.size(); ++k) {
    require(read[k].key == again[k].key, "two readings of a comment differ in a key");
    require(read[k].value == again[k].value, "two readings of a comment differ in a value");
    require(read[k].complete == again[k].complete, "two readings of a comment differ in what is complete");
  }
  mentions_box(text);
}
