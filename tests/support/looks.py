"""What a page is looked at with: a phone, what is too wide on it, what a finger does not hit."""

PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}
"""A phone held upright, px."""
WIDE = """() => {
  const root = document.scrollingElement;
  const beyond = (one) => one.getBoundingClientRect().right > root.clientWidth + 1 && one.checkVisibility();
  const name = (one) => `${one.localName}.${one.className.baseVal ?? one.className}`;
  const all = [...document.querySelectorAll("body *")];
  return root.scrollWidth <= root.clientWidth ? [] : all.filter(beyond).map(name);
}"""
"""What sticks out to the right where a page can be pushed sideways."""
SMALL = """() => [...document.querySelectorAll("button, select, input, a[href], [role=slider], [role=tab]")]
  .filter((one) => one.checkVisibility())
  .map((one) => one.labels?.[0] ?? one)
  .map((one) => [one.getAttribute("aria-label") ?? one.textContent.trim(), one.getBoundingClientRect()])
  .filter(([, { width, height }]) => width < 43.5 || height < 43.5)
  .map(([name, { width, height }]) => `${name}: ${width} × ${height}`)"""
"""What can be clicked and is less than 44 px wide or high, with its size."""
