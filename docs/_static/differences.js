// On the page of deliberate differences: a field that filters the cards, and an anchor for each, as #tf2-wait.
document.addEventListener("DOMContentLoaded", () => {
  const page = document.getElementById("deliberate-differences");
  if (!page) return;

  const areas = [...page.querySelectorAll(":scope > section")];
  const cards = [...page.querySelectorAll("tbody tr")];
  const texts = new Map(cards.map((card) => [card, card.textContent.toLowerCase()]));
  for (const card of cards) card.id = card.cells[0].textContent.trim();

  const bar = document.createElement("div");
  bar.className = "differences-filter";
  const field = document.createElement("input");
  field.type = "search";
  field.placeholder = "Filter: a command, a class, a word …";
  field.setAttribute("aria-label", "Filter the differences");
  const count = document.createElement("output");
  bar.append(field, count);
  areas[0].before(bar);

  function filter() {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const card of cards) card.hidden = !words.every((word) => texts.get(card).includes(word));
    for (const area of areas) area.hidden = !area.querySelector("tbody tr:not([hidden])");
    const shown = cards.filter((card) => !card.hidden).length;
    count.textContent = shown === cards.length ? `${shown} differences` : `${shown} of ${cards.length}`;
  }

  // A link to a card or heading that is filtered out shows all.
  function showTarget() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target || !page.contains(target)) return;
    if (target.closest("[hidden]")) {
      field.value = "";
      filter();
    }
    target.scrollIntoView();
  }

  field.addEventListener("input", filter);
  window.addEventListener("hashchange", showTarget);
  filter();
  if (location.hash) showTarget();
});
