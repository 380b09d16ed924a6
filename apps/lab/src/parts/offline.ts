// The lab without a network: a service worker keeps its files in the browser.

const loopback = ["localhost", "127.0.0.1", "[::1]"];

/** Keeps the lab from the next visit on. A page that comes from this machine is there without a network as well, and its
 *  port may be another program's tomorrow: for such a page nothing is kept. */
export function keepOffline(): void {
  if (!import.meta.env.PROD || loopback.includes(location.hostname) || !("serviceWorker" in navigator)) return;
  navigator.serviceWorker.register("./service-worker.js").catch(() => {}); // storage is forbidden: the lab works without
}
