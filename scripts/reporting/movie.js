// Shows frame i of the movie; the slider, the button and the arrow keys (on the slider) select i.
const movie = JSON.parse(document.getElementById("frames").textContent);
const slider = document.getElementById("frame"), button = document.getElementById("play");
let timer = 0;
function show(i) {
  slider.value = i;
  for (const view of ["above", "side"]) document.getElementById(view).src = movie[view][i];
  const plane = document.getElementById("plane");
  if (plane) {
    plane.src = movie.plane[movie.nearest[i]];
    document.getElementById("plane_time").textContent = movie.plane_times[movie.nearest[i]].toFixed(3) + " s";
  }
  document.getElementById("time").textContent = movie.times[i].toFixed(3) + " s";
  const x = movie.x[i];
  document.getElementById("cursor").setAttribute("d", `M${x} 0V100`);
}
function stop() { clearInterval(timer); timer = 0; button.textContent = "Play"; }
button.addEventListener("click", () => {
  if (timer) return stop();
  button.textContent = "Pause";
  timer = setInterval(() => show((+slider.value + 1) % movie.times.length), 90);
});
slider.addEventListener("input", () => { stop(); show(+slider.value); });
show(+slider.value);
