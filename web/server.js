// SPDX-License-Identifier: MIT
// Requests of a page to the server that has served it.
export const token = new URLSearchParams(location.search).get("token") ?? "";

export const gone = "grafverif does not respond; restart it and open the address that it prints";

export async function ask(path, body) {
    const answer = await fetch(path, {
        method: body === undefined ? "GET" : "POST",
        body: body === undefined ? undefined : JSON.stringify(body),
        headers: {"X-Grafverif-Token": token},
        cache: "no-store",
    }).catch(() => { throw new Error(gone); });
    if (!answer.ok) throw new Error((await answer.text()).trim());
    return answer.json();
}
