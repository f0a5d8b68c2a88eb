/** Elements of a page, made in one expression. */

export function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  properties: Partial<HTMLElementTagNameMap[Name]>,
  ...children: HTMLElement[]
): HTMLElementTagNameMap[Name] {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

export function button(text: string, act: () => void): HTMLButtonElement {
  const made = element('button', { textContent: text, id: `look-${text}` });
  made.addEventListener('click', act);
  return made;
}

/** A switch that is on. */
export function check(id: string, text: string): { label: HTMLLabelElement; input: HTMLInputElement } {
  const input = element('input', { id, type: 'checkbox', checked: true });
  const label = element('label', {}, input);
  label.append(text);
  return { label, input };
}
