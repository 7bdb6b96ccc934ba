// What tsc does not see: faults that are legal, ways past the page's policy, files and functions that grow too long.
import js from "@eslint/js";

const lines = ["XMLHttpRequest", "WebSocket", "Worker", "DOMParser"];
const markup = ["innerHTML", "outerHTML", "insertAdjacentHTML", "srcdoc", "write", "writeln"];

export default [
  js.configs.recommended,
  {
    languageOptions: { ecmaVersion: 2022, sourceType: "module" },
    linterOptions: { reportUnusedDisableDirectives: "error" },
    rules: {
      "no-undef": "off", // tsc tells it
      "no-unused-vars": "off", // tsc tells it
      "no-eval": "error",
      "no-implied-eval": "error",
      "no-new-func": "error",
      "no-script-url": "error",
      "no-console": "error",
      "no-alert": "error",
      "no-var": "error",
      "prefer-const": "error",
      "eqeqeq": "error",
      "no-shadow": "error",
      "no-restricted-globals": ["error", "fetch", "EventSource", ...lines],
      "no-restricted-properties": ["error", ...markup.map((property) => ({ property }))],
      "no-restricted-syntax": ["error", "ImportExpression", "ExportDefaultDeclaration"],
      "complexity": ["error", 12], // every ?? and ?. counts
      "max-lines": ["error", 250],
    },
  },
  // the studio asks its server, by one module
  { files: ["**/serve/web/wire.js"], rules: { "no-restricted-globals": ["error", ...lines] } },
];
