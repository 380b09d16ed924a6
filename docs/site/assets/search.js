// What the reader looks for, in an index of {name, in, at, text}: every word has to be found, in the name or the text.
"use strict";

// The entries found, best first. A name that is what was asked for comes first, then names that begin so, then texts
// that hold the words as they stand, then those that hold them anywhere.
globalThis.grazeFind = (index, question, most = 60) => {
  const phrase = question.trim().toLowerCase().replace(/\s+/g, " ");
  const words = phrase.split(/[\s:.()]+/).filter(Boolean);
  if (words.length === 0) return [];
  const found = [];
  for (const entry of index) {
    const name = entry.name.toLowerCase(), text = (entry.text ?? "").toLowerCase(), where = (entry.in ?? "").toLowerCase();
    let score = 0;
    for (const word of words) {
      const at = name.indexOf(word);
      const points = name === word ? 60 : at === 0 ? 30 : at > 0 ? 15 : where.includes(word) ? 6 : text.includes(word) ? 4 : 0;
      if (points === 0) { score = -1; break; }
      score += points;
    }
    if (score < 0) continue;
    if (name === phrase || name.endsWith(`::${phrase}`)) score += 100;
    else if (words.length > 1 && name.includes(phrase)) score += 60;
    else if (words.length > 1 && text.includes(phrase)) score += 20;
    if (entry.text !== undefined) score += entry.in === "" ? 13 : 3;  // a page explains, a name only says where it stands
    found.push({ entry, score });
  }
  found.sort((a, b) => b.score - a.score || a.entry.name.length - b.entry.name.length || (a.entry.at < b.entry.at ? -1 : 1));
  return found.slice(0, most).map(({ entry }) => entry);
};

// The part of a text around the first of the words.
globalThis.grazeExcerpt = (entry, question) => {
  const text = entry.text ?? "", low = text.toLowerCase(), phrase = question.trim().toLowerCase().replace(/\s+/g, " ");
  let at = low.indexOf(phrase);
  if (at < 0) at = low.indexOf(phrase.split(/\s+/)[0]);
  const begin = Math.max(0, at - 60);
  return (begin > 0 ? "… " : "") + text.slice(begin, begin + 180) + (begin + 180 < text.length ? " …" : "");
};
