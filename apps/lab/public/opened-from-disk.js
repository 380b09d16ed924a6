// Says what is missing where the page was opened as a file: no browser loads modules or WebAssembly from there.
if (location.protocol === "file:") {
  const words = document.createElement("p");
  words.setAttribute("role", "alert");
  words.textContent = "The lab was opened as a file of the disk, from which a browser loads neither modules nor WebAssembly. " +
    "Serve its folder, for example by: python3 -m http.server -d apps/lab/dist, and open http://localhost:8000; or run: graze view";
  document.getElementById("app").replaceChildren(words);
}
