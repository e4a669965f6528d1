
// ./lab demo --watch writes two scripts next to the page: a small one, which changes with each
// measurement, and the data. There is no server, so the page asks for them again and again.

const news = html("p", { id: "watch", role: "status" });
document.body.append(news);
document.documentElement.style.scrollPaddingBottom = "6rem";  // no control hides below the news
let version = "";
function load(name) {
  const script = html("script", { src: `${location.pathname}.${name}.js?${Date.now()}` });
  script.onload = script.onerror = () => script.remove();
  document.head.append(script);
}
function follow(newest) {
  if (newest !== version) load("data");
  version = newest;
}
function receive(data, remarks, text) {
  take(data, remarks);
  news.textContent = text || `Measured at ${new Date().toLocaleTimeString()}.`;
}
setInterval(load, 250, "version");
