var el=class{#e;#t=new Map;#n=[];#i=!1;constructor(t){this.#e=t}shownIn(t,e){this.#n.push(e),this.#t.set(t,!1),new IntersectionObserver(n=>{this.#t.set(t,n.at(-1).isIntersecting),this.#s()}).observe(t)}#s(){let t=[...this.#t.values()].includes(!0);if(t===this.#i)return;this.#i=t;let e=(n,s)=>this.#n.forEach(r=>r(n,s));this.#e.sampleActivity(t?e:null)}};var Ho=class{constructor(t){this.name=t}toString(){return this.name}},Zt=i=>new Ho(i),j=i=>i instanceof Ho?i.name:typeof i=="string"?i:"",Nd=/\s*(?:;[^\n]*\n\s*)*(\(|\)|"(?:[^"\\]|\\.)*"|[^\s()";]+)/y,U_={n:`
`,t:"	"};function F_(i){return i[0]==='"'?i.slice(1,-1).replace(/\\(.)/gs,(t,e)=>U_[e]??e):/^[-+]?\d/.test(i)?Number(i):new Ho(i)}function Ri(i){Nd.lastIndex=0;let t=[[]];for(;;){let e=Nd.exec(i);if(!e)break;if(e[1]==="(")t.push([]);else if(e[1]===")"){let n=t.pop();if(t.length===0)return[];t[t.length-1].push(n)}else t[t.length-1].push(F_(e[1]))}return t[0][0]??[]}var O_=i=>`"${i.replace(/[\\"]/g,"\\$&").replace(/\n/g,"\\n").replace(/\t/g,"\\t").replace(/[\0-\x08\x0b-\x1f]/g," ")}"`;function Fe(i){return Array.isArray(i)?`(${i.map(Fe).join(" ")})`:typeof i=="string"?O_(i):String(i)}var nl=class{#e=new Map;#t;constructor(t){this.#t=t}change(t){t.resynchronised&&this.#e.clear();for(let e of t.removed)this.#e.delete(e.join());for(let e of t.added)this.#e.set(e.ids.join(),e);this.#t([...this.#e.values()],t)}};function pt(i){return i.read??=Ri(i.facts[0].text),i.read}var il=class{#e=null;#t=1;#n=new Map;#i=new Map;#s=new Map;#r=new Map;#o=500;#a=0;#c=0;#u=null;#f=null;#d=null;#p=new Map;onState=()=>{};onHello=()=>{};onArm=()=>{};onPulse=()=>{};async open(){let t=location.hash.slice(1);t&&history.replaceState(null,"",location.pathname),await this.logIn(t)}async logIn(t){t&&await fetch("/session",{method:"POST",headers:{Authorization:`Bearer ${t}`}}).catch(()=>null),this.#h()}async logOut(){await fetch("/socket",{method:"DELETE"}).catch(()=>null),location.reload()}#h(){this.onState("connecting");let t=new WebSocket(`${location.protocol.replace("http","ws")}//${location.host}/socket`);t.binaryType="arraybuffer",t.onmessage=e=>typeof e.data=="string"?this.#M(JSON.parse(e.data)):this.#w(e.data),t.onclose=()=>this.#_(),this.#e=t}async#_(){this.#e=null,this.#a=0,this.#c=0;for(let e of this.#p.values())e({error:{symbol:"unreachable"}});this.#p.clear();for(let e of this.#i.values())e.reject({symbol:"unreachable",sentence:"the console has gone; whether it was done is not known"});if(this.#i.clear(),(await fetch("/socket").catch(()=>null))?.status===403)return this.onState("refused");this.onState("lost"),setTimeout(()=>this.#h(),this.#o),this.#o=Math.min(this.#o*2,4e3)}#l(...t){return this.#e?.readyState!==WebSocket.OPEN?!1:(this.#e.send(Fe(t)),!0)}#M(t){if(t.error&&(t.error.said=t.said),t.hello){this.#o=500,this.onHello(t.hello),this.onState("live");for(let[e,n]of this.#n)this.#g(e,n);for(let e of this.#s.keys())this.#l(Zt("look"),Zt(e));this.#u&&this.#l(Zt("truth")),this.#f&&this.#l(Zt("activity"))}else if(t.arm)(t.past??null)===this.#d&&this.onArm(t),this.#x();else if(t.watch){let e=this.#n.get(t.watch);(t.past??null)===(e?.always?null:this.#d)&&e?.take(t),t.error||this.#x(),t.past&&this.#p.get(t.watch)?.(t)}else"truth"in t?(this.#u?.(t.truth===null?null:Ri(t.truth),t.said),this.#x()):"activity"in t?(this.#f?.(t.activity,t.said),this.#x()):t.pulse?(this.#c=t.pulse,this.#l(Zt("stamp"),t.pulse),this.onPulse(t)):t.reply&&(this.#i.get(t.reply)?.take(t),this.#p.get(t.reply)?.(t),t.error&&this.#n.get(t.reply)?.take(t))}#x(){this.#a++>0||setTimeout(()=>{this.#l(Zt("heard"),this.#a),this.#a=0},5)}#g(t,e){e.once?this.#l(Zt("ask"),t,Ri(e.query)):e.typed?this.#l(Zt("watch"),t,e.query):this.#l(Zt("follow"),t,Ri(e.query))}#y(t,e,n,s,r=!1){let o=this.#t++,a=new nl(n),l=c=>c.error?s(c.error):a.change(c);return this.#n.set(o,{query:t,typed:e,take:l,always:r}),this.#g(o,this.#n.get(o)),()=>{this.#n.delete(o),this.#l(Zt("unwatch"),o)}}follow(t,e){this.#v(t,e,!1)}followAlways(t,e){this.#v(t,e,!0)}#v(t,e,n){let s=`${n} ${t}`,r=this.#r.get(s)??{listeners:[],told:null};if(r.listeners.push(e),r.told&&e(...r.told),this.#r.has(s))return;this.#r.set(s,r);let o=(...a)=>{r.told=a;for(let l of r.listeners)l(...a)};this.#y(t,!1,o,()=>{},n)}watch(t,e,n){return this.#y(t,!0,e,n)}ask(t){let e=this.#t++;return new Promise(n=>{let s=r=>{this.#n.delete(e),n(r.added??[])};this.#n.set(e,{query:Fe(t),once:!0,take:s,always:!0}),this.#g(e,this.#n.get(e))})}async askThen(t,e){let n=this.#t++,s=await this.#S(n,t,e);if(this.#p.delete(n),s.error)throw s.error;return s.added}get moment(){return this.#d}async showMoment(t){if(this.#d=t,t===null){for(let[r,o]of this.#n)o.always||(this.#l(Zt("unwatch"),r),this.#g(r,o));return null}let e=[...this.#n].filter(([,r])=>!r.always),n=null,s=async()=>{for(;e.length&&this.#d===t;){let[r,o]=e.shift(),a=await this.#S(r,o.query,t);a.error?.symbol==="undeclared-relation"?o.take({resynchronised:!0,cut:0,removed:[],added:[]}):n??=a.error??null}};return await Promise.all([s(),s(),s(),s()]),n}#S(t,e,n){return new Promise(s=>{this.#p.set(t,s),this.#l(Zt("then"),t,Ri(e),n)||s({error:{symbol:"unreachable"}})})}#m(t,e,...n){let s=this.#t++;return new Promise((r,o)=>{let a=l=>{t&&!l.error?this.#i.set(s,{reject:()=>{},take:c=>this.#b(s,t,c)}):this.#i.delete(s),l.error?o(l.error):r(l.values)};this.#i.set(s,{reject:o,take:a}),!this.#l(Zt(e),s,...n)&&(this.#i.delete(s),o({symbol:"unreachable",sentence:"the console is not connected"}))})}#b(t,e,n){this.#i.delete(t),e(n)}request(t,e){return this.#m(null,"request",Zt(t),typeof e=="string"?Ri(e):e)}goal(t,e){return this.#m(e,"goal",t)}stop(t){return this.#m(null,"stop",t)}clearStops(){return this.#m(null,"clear-stops")}hold(t,e){return this.#m(null,t,Zt(e))}layTruth(t){this.#u=t,this.#l(Zt(t?"truth":"truth-no-more"))}sampleActivity(t){this.#f=t,this.#l(Zt(t?"activity":"activity-no-more"))}async method(t){let[e]=await this.#m(null,"method",t);return JSON.parse(e)}jog(t,e){return this.#m(null,"jog",Zt(t),Zt(e),this.#c)}holdOn(){this.#l(Zt("hold-on"),this.#c)}release(){this.#l(Zt("release"))}look(t,e){return this.#s.set(t,e),this.#l(Zt("look"),Zt(t)),()=>{this.#s.delete(t),this.#l(Zt("look-away"),Zt(t))}}async picture(t,e){let[n]=await this.#m(null,"picture",Zt(t),e);return n}async#w(t){let e=new Uint8Array(t),n=e.indexOf(10),[s,r,o,a,l,c]=Ri(new TextDecoder().decode(e.subarray(0,n))),h=await createImageBitmap(new Blob([e.subarray(n+1)],{type:"image/jpeg"})).catch(()=>null);if(j(s)==="picture"){let f={values:[{bitmap:h,number:o,captured:a,width:l,height:c}]};return this.#i.get(r)?.take(h?f:{error:{sentence:"what was kept is no picture"}})}let u=j(r);requestAnimationFrame(()=>{h&&this.#s.get(u)?.({bitmap:h,number:o,captured:a,width:l,height:c}),h?.close(),this.#l(Zt("drawn"),Zt(u))})}};var Ut=i=>document.getElementById(i),R=(i,t,...e)=>Ud(document.createElement(i),t,e),Sn=(i,t,...e)=>Ud(document.createElementNS("http://www.w3.org/2000/svg",i),t,e);function Ud(i,t={},e=[]){for(let[n,s]of Object.entries(t))n.startsWith("on")?i.addEventListener(n.slice(2),s):s===!0?i.setAttribute(n,""):s!==!1&&s!=null&&i.setAttribute(n,s);return i.append(...e.filter(n=>n!=null)),i}function Fd(i,t){let e=new Set(t);for(let n of[...i.children])e.has(n)||n.remove();t.forEach((n,s)=>{let r=i.children[s];r!==n&&i.insertBefore(n,r??null)})}var Jt=(i,t=300)=>i.length>t?`${i.slice(0,t)} \u2026 (${i.length} characters)`:i,tn=i=>new Date(i/1e3).toLocaleTimeString("en-GB",{hour12:!1}),Ae=i=>Jt(i.said??i.sentence,1600);function ni(i){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,i()}))}}function sl(i){let t=Ut("confirm");return Ut("confirm-text").textContent=i,t.showModal(),new Promise(e=>{let n=new AbortController,s=r=>{n.abort(),e(r)};t.addEventListener("submit",r=>s(r.submitter?.value==="yes"),{signal:n.signal}),t.addEventListener("close",()=>t.open||s(!1),{signal:n.signal})})}var rl=class{#e;#t=[];#n=[];#i=[];#s="";#r=!1;change=null;me="";robot="robot";constructor(t){this.#e=t,t.followAlways("(commander ?robot ?client)",e=>{this.#n=e.map(pt),this.#o(),this.changed()}),t.followAlways("(commander-wanted ?robot ?client)",e=>{this.#i=e.map(pt),this.changed()})}get holder(){let t=this.#n.find(e=>j(e[1])===this.robot);return t?j(t[2]):""}get mine(){return this.me!==""&&this.holder===this.me}get askers(){return this.#i.filter(e=>j(e[1])===this.robot).map(e=>j(e[2])).filter(e=>e!==this.me)}get asking(){return this.#i.some(t=>j(t[1])===this.robot&&j(t[2])===this.me)}#o(){let t=this.#s,e=this.holder;this.#s=e,t!==e&&(e===this.me?this.change=t?{from:t,to:e}:null:e&&t===this.me&&(this.change={from:t,to:e}))}onChange(t){this.#t.push(t),t(this.mine,this.holder)}changed(){let t=Ut("arm-chip");t.hidden=this.holder==="",t.textContent=this.mine?"arm: in your hands":`arm: ${this.holder}`,t.className=this.mine?"chip good":"chip warn";for(let e of this.#t)e(this.mine,this.holder);this.#a()}async#a(){if(!this.asking||this.#r||!(this.mine||this.holder===""))return;this.#r=!0;let t=this.mine?"ask-no-more":"command";await this.#e.hold(t,this.robot).catch(()=>{}),this.#r=!1,this.mine&&this.#a()}async toggle(){return this.mine?this.#e.hold("let-go",this.robot):this.holder===""?this.#e.hold("command",this.robot):await sl(`${this.holder} has the arm in hand. Take it over? Its motion ends.`)?this.#e.hold("take-over",this.robot):void 0}toggleWish(){return this.#e.hold(this.asking?"ask-no-more":"ask-for",this.robot)}};function fs(i,t){let e=R("tbody",{}),n=s=>R("td",{},s instanceof Node?s:Jt(String(s)));return{panel:R("table",i,R("thead",{},R("tr",{},...t.map(s=>R("th",{},s)))),e),fill:s=>e.replaceChildren(...s.map(r=>R("tr",{},...r.map(n))))}}var Od=10,ol=560,Bd=220,Wo={width:104,height:26},kd=["QUERY","SEND","PUSH","EVENT","STREAM"];function B_({components:i,connections:t}){let e=new Map(i.map(({name:o},a)=>{let l=2*Math.PI*a/i.length-Math.PI/2;return[o,{x:ol/2+(Bd+10)*Math.cos(l),y:ol/2+Bd*Math.sin(l)}]})),n=({from:o,to:a,pattern:l,about:c})=>{let[h,u]=[e.get(o),e.get(a)];if(!h||!u)return null;let f=Math.max(Math.hypot(u.x-h.x,u.y-h.y),1),[d,m]=[(u.x-h.x)/f,(u.y-h.y)/f],y=4+5*kd.indexOf(l),p=Math.min(Wo.width/2/Math.max(Math.abs(d),.01),Wo.height/2/Math.max(Math.abs(m),.01))+4,g={x1:h.x+d*p+m*y,y1:h.y+m*p-d*y,x2:u.x-d*p+m*y,y2:u.y-m*p-d*y},v=Sn("title",{},`${o} ${l} ${a}: ${c.join(" ")}`);return Sn("line",{...g,class:`way ${l}`,"marker-end":`url(#end-${l})`},v)},s=kd.map(o=>Sn("marker",{id:`end-${o}`,markerWidth:7,markerHeight:7,refX:6,refY:3,orient:"auto"},Sn("path",{d:"M0,0 L6,3 L0,6 z",class:o}))),r=[...e].flatMap(([o,{x:a,y:l}])=>[Sn("rect",{x:a-Wo.width/2,y:l-Wo.height/2,...Wo,rx:5,class:"component"}),Sn("text",{x:a,y:l+4,"text-anchor":"middle"},Jt(o,14))]);return Sn("svg",{class:"graph",viewBox:`0 0 ${ol} ${ol}`,role:"img","aria-label":`${i.length} components and ${t.length} connections`},Sn("defs",{},...s),...t.map(n).filter(Boolean),...r)}var zd={physical:"a device",performance:"a reaction time",abstraction:"a function"};function k_({components:i,wrappers:t}){let e=new Map(t.map(n=>[n.component,n]));return i.map(n=>{let s=e.get(n.name),r=Object.keys(zd).filter(a=>n[a]).map(a=>zd[a]),o=(s?.abstraction??[]).map(a=>`${a.wrapped} ${a.operations}/${a.functions} = ${a.i_abstract.toFixed(3)}`);return[n.name,r.join(", ")||"none told",s?.offered??0,o.join("; ")||"\u2013",(s?.parts??[]).join(" ")]})}function z_({connections:i}){return i.map(t=>[`${t.from} \u2192 ${t.to}`,t.pattern,t.count,t.p50_ms?`${t.p50_ms.toFixed(1)} / ${t.p99_ms.toFixed(1)}`:"\u2013",t.about.join(" "),t.remark||(t.recommended===t.pattern?"as the tables have it":t.recommended)])}function al(i,...t){return R("section",{"aria-label":i},R("h2",{},i),...t)}function tu(i,t,e){let n=fs({id:i},t);return n.fill(e),R("div",{class:"scroll",tabindex:0,role:"group","aria-label":t[0]},n.panel)}function V_(i){let{i_cpx:t,i_struct:e,i_cnx:n}=i,s=i.scales.map(({subscribers:r,p50_ms:o})=>`${r}: ${o.toFixed(2)} ms`).join(", ");return[al("Divide",R("p",{id:"indices"},`I_cpx ${t.toFixed(3)}, I_struct ${e.toFixed(3)}, I_cnx ${n.toFixed(3)}`),B_(i),R("p",{class:"quiet"},"QUERY blue, SEND violet, PUSH green, EVENT orange, STREAM grey.")),al("Wrap",tu("wrappers",["Component","Is one for","Operations","I_abstract","Parts of a wrapper"],k_(i))),al("Connect",tu("connections",["Connection","Pattern","Times","ms p50 / p99","About","The tables say"],z_(i))),al("What is wrong",i.faults.length?tu("faults",["Fault","Of","Why"],i.faults.map(r=>[r.symbol,r.subject,r.sentence])):R("p",{},"no fault was found"),s&&R("p",{class:"quiet"},`A fact reaches so many readers: ${s}.`))]}function Vd(i){let t=R("span",{class:"quiet",role:"status",id:"method-note"}),e=R("div",{id:"method"}),n=R("button",{type:"button",id:"method-look"},`Look for ${Od} s`);return n.addEventListener("click",async()=>{n.disabled=!0,t.textContent="looking at who asks, answers, tells and watches \u2026";try{let s=await i.method(Od);e.replaceChildren(...V_(s).filter(Boolean)),t.textContent=`seen for ${s.seconds} s`}catch(s){t.textContent=Ae(s)}n.disabled=!1}),R("details",{class:"goals"},R("summary",{},"The method: Divide, Wrap, Connect"),R("div",{class:"row"},n,t),e)}function Gd(i,t){let e=fs({id:"processes"},["Process","Host","Restarts","The last of it"]),n=R("span",{class:"quiet"},"0"),s=new Map;return i.follow("(process ?host ?name ?running ?restarts ?newest)",o=>{let a=o.map(pt).sort((l,c)=>j(l[2]).localeCompare(j(c[2])));s.clear();for(let[,,l,,c]of a)s.set(j(l),c);n.textContent=String(a.length),e.fill(a.map(([,l,c,h,u,f])=>[j(c),j(l),u,j(h)==="yes"?j(f):R("span",{class:"chip bad"},j(f))])),t()}),{panel:R("details",{class:"goals"},R("summary",{},"Processes and their restarts ",n),e.panel),restarts:s}}var Hd=50;function Wd(i,t){let e=R("span",{class:"quiet",id:"refusal-count"},"0"),n=fs({id:"refusals"},["Client","Refused","Times","The newest"]),s=fs({id:"clients"},["Client","Requests/s"]);i.follow("(board-refusal ?client ?symbol ?count ?sentence)",o=>{let a=o.map(pt).sort((l,c)=>c[3]-l[3]);e.textContent=String(a.length),n.fill(a.slice(0,Hd).map(([,l,c,h,u])=>[j(l),j(c),h,j(u)]))});let r=R("details",{class:"goals"},R("summary",{},"Refused by the board ",e),n.panel,s.panel);return t.shownIn(r,o=>s.fill((o?.clients??[]).slice(0,Hd).map(a=>[a.name||"(no hello)",a.requests_per_second]))),r}var G_={wired:"","stands-in":"stands in",absent:"is away"},H_=64;function Xd(i){let t=R("tbody",{}),e=["Client","Role","Is played by",""].map(s=>R("th",{},s));i.follow("(holder ?client ?role ?server ?state)",s=>{let r=s.map(o=>pt(o).slice(1).map(j)).sort();t.replaceChildren(...r.slice(0,H_).map(([o,a,l,c])=>R("tr",{class:c==="wired"?"":"warn"},...[o,a,l,G_[c]??c].map(h=>R("td",{},Jt(h,64))))))});let n=R("table",{id:"served"},R("thead",{},R("tr",{},...e)),t);return R("details",{class:"goals",open:!0},R("summary",{},"Who serves whom"),n)}function W_(i,t){let e=i?`${i.told_per_second.toFixed(1)} told/s, ${i.waiting} waiting, ${i.queued} queued`:"",n=t===void 0?"":`${t} restart${t===1?"":"s"}`;return[e,n].filter(Boolean).join(", ")}function qd(i,t){let e=R("div",{class:"timeline"}),n=new Map,s=new Map,r=[],o=new Map,a=h=>{if(s.has(h))return s.get(h);let u=R("span",{class:"quiet"}),f=R("span",{class:"quiet load"}),d=R("pre",{}),m=R("details",{"data-agent":h},R("summary",{},R("strong",{},Jt(h,64)),u,f),d);return s.set(h,{made:m,who:u,does:f,offers:d}),s.get(h)},l=()=>{let h=r.slice(0,64).map(u=>{let f=j(u[1]),{who:d,does:m,offers:y}=a(f);d.textContent=`${j(u[2])} on ${Jt(j(u[3]),64)}`,m.textContent=W_(o.get(f),c.restarts.get(f));let p=n.get(f);return y.textContent=p?Jt(p.map(Fe).join(`
`),6e3):"it told no contract",f});for(let u of s.keys())h.includes(u)||s.delete(u);e.replaceChildren(...h.map(u=>s.get(u).made))},c=Gd(i,()=>l());Ut("agents").append(e,c.panel,Wd(i,t),Xd(i),Vd(i)),t.shownIn(e,h=>{o=new Map((h?.agents??[]).map(u=>[u.name,u])),l()}),i.follow("(agent ?name ?kind ?host)",h=>{r=h.map(pt).sort((u,f)=>j(u[1]).localeCompare(j(f[1]))),l()}),i.follow("(contract ?name ?form)",h=>{n.clear();for(let[,u,f]of h.map(pt))n.set(j(u),f.filter(Array.isArray));l()})}var X_=60,Fr=class{#e;#t;#n;list;constructor(t,e,n,s){this.#e=t,this.#t=e,this.#n=n,this.list=R("ol",{class:"log","aria-label":s}),t.followAlways("(request ?id ?agent ?operation)",(r,o)=>this.#s(o.added))}#i(t,e){let n=R("span",{}),s=R("li",{},R("time",{},tn(Date.now()*1e3)),R("span",{class:"quiet"},`${Jt(t,40)} `),R("code",{},Jt(e,200)),n);for(this.list.prepend(s);this.list.children.length>X_;)this.list.lastChild.remove();return{item:s,answer:n}}#s(t){for(let e of t){let{teller:n}=e.facts[0],[,,s,r]=pt(e);j(s)===this.#t()&&n!==this.#n()&&this.#i(n,Fe(r))}}async follow(t,e){let{item:n,answer:s}=this.#i("you",t);s.textContent=" \u2026";try{s.textContent=` ${Jt((await e).join(" ")||"ok",200)}`}catch(r){s.textContent=` ${Ae(r)}`,n.className="bad"}}send(t){return this.follow(t,this.#e.request(this.#t(),Ri(t)))}};var q_=50,$_=[["left","\u25C0","Left"],["up","\u25B2","Up"],["out","\u21E7","Out"],["turn-left","\u27F2","Turn left"],["tool-up","\u2912","Tool up"],["wrist-left","\u21BA","Wrist left"],["right","\u25B6","Right"],["down","\u25BC","Down"],["in","\u21E9","In"],["turn-right","\u27F3","Turn right"],["tool-down","\u2913","Tool down"],["wrist-right","\u21BB","Wrist right"]],eu=class{#e;#t;#n;#i=0;#s=null;#r=null;constructor(t,e,n){this.#e=t,this.#t=e,this.#n=n,window.addEventListener("blur",()=>this.end()),window.addEventListener("pagehide",()=>this.end()),document.addEventListener("visibilitychange",()=>{document.hidden&&this.end()})}begin(t,e){if(this.#s||!this.#t.mine)return;let n={button:e};this.#s=n,e.classList.add("held");let s=()=>this.#s===n&&this.#o(t,n);this.#r?this.#r.then(s):s()}#o(t,e){let n=this.#e.jog(this.#t.robot,t);this.#n.follow(`(jog ${t})`,n),this.#i=setInterval(()=>this.#e.holdOn(),q_);let s=()=>{this.#r=null,this.#s===e&&this.end()};this.#r=n.then(s,s)}end(){this.#s&&(clearInterval(this.#i),this.#e.release(),this.#s.button.classList.remove("held"),this.#s=null)}};function Y_(i,[t,e,n]){let s=R("button",{type:"button",class:"jog","data-jog":t,"aria-label":`Jog: ${n}`,title:n},R("span",{"aria-hidden":"true"},e),R("small",{"aria-hidden":"true"},n));s.addEventListener("pointerdown",r=>{r.button===0&&(s.setPointerCapture(r.pointerId),i.begin(t,s))});for(let r of["pointerup","pointercancel","lostpointercapture","blur"])s.addEventListener(r,()=>i.end());return s.addEventListener("contextmenu",r=>r.preventDefault()),s.addEventListener("keydown",r=>{r.key==="Escape"&&i.end(),!(r.key!==" "&&r.key!=="Enter")&&(r.preventDefault(),r.repeat||i.begin(t,s))}),s.addEventListener("keyup",r=>{(r.key===" "||r.key==="Enter")&&i.end()}),s}function $d(i,t,e){let n=new eu(i,t,e),s=$_.map(a=>Y_(n,a)),r=R("p",{class:"quiet",id:"jog-note"},"");return i.onPulse=({deadline:a,rtt:l})=>{let c=l<0?"not measured yet":`${l.toFixed(0)} ms there and back`;r.textContent=`Hold to move. Line: ${c}; silence of ${a.toFixed(0)} ms stops the arm, within 10 mm.`},{parts:[R("div",{class:"jogs",role:"group","aria-label":"Jog: hold to move"},...s),r],buttons:s}}var Z_=/^(Arrow\w+|Page\w+|Home|End)$/;function Yd(i,t,e){let n=R("output",{},""),s=R("input",{type:"range","aria-label":i,...e}),r=()=>{n.textContent=`${s.value} ${t}`,s.setAttribute("aria-valuetext",n.textContent)};return s.addEventListener("input",r),r(),{row:R("label",{class:"slide"},R("span",{},i),s,n),input:s,show:r}}function Zd(i,{letGo:t,drop:e}){let n="";i.addEventListener("pointerdown",()=>n="pointer"),i.addEventListener("keydown",r=>{Z_.test(r.key)&&(n="key")});let s=()=>{n="",t()};i.addEventListener("change",()=>n!=="key"&&s()),i.addEventListener("keyup",()=>n==="key"&&s()),i.addEventListener("pointerup",()=>n="");for(let r of["pointercancel","blur"])i.addEventListener(r,()=>{n="",e()});return()=>n!==""}function ll({label:i,unit:t,most:e,form:n},s){let{row:r,input:o,show:a}=Yd(i,t,{min:-e,max:e,step:1,value:0}),l=()=>{let h=Number(o.value);return o.value=0,a(),h};return Zd(o,{letGo:()=>{let h=l();h!==0&&s(n(h))},drop:l}),o.addEventListener("keydown",h=>h.key==="Escape"&&l()),{row:r,input:o}}function Xo({label:i,unit:t,least:e,most:n,value:s,form:r},o){let{row:a,input:l,show:c}=Yd(i,t,{min:e,max:n,step:1,value:s}),h=s,u=()=>{l.value=h,c()},f=Zd(l,{letGo:()=>o(r(Number(l.value))),drop:u});return{row:a,input:l,put:m=>{h=m,f()||u()}}}var qo=(i,t,e)=>n=>`(${i} ${n>0?t:e} ${Math.abs(n)})`,J_=[{label:"Retract / extend",unit:"mm",most:100,form:i=>i>0?`(extend keep-height ${i})`:`(retract ${-i})`},{label:"Turn left / right",unit:"\xB0",most:45,form:qo("turn","right","left")},{label:"Move left / right",unit:"mm",most:100,form:qo("move-h","right","left")},{label:"Move down / up",unit:"mm",most:100,form:qo("move-v","up","down")},{label:"Tool down / up",unit:"\xB0",most:45,form:qo("turn-ef","up","down")},{label:"Wrist left / right",unit:"\xB0",most:90,form:qo("turn-wrist","right","left")}],K_={label:"Gripper",unit:"mm",least:0,most:100,value:80,form:i=>`(gripper ${i})`},j_={label:"Speed",unit:"%",least:1,most:100,value:50,form:i=>`(speed ${i})`};function Q_(i,t){let e=R("output",{class:"axes","aria-label":"Axis positions"},"no arm has told its joints yet");return i.follow("(arm-joints ?robot ?joints)",n=>{let s=n.map(pt).find(r=>j(r[1])===t.robot);s&&(e.textContent=s[2].map((r,o)=>`j${o+1} ${r.toFixed(1)}`).join("   "))}),e}function tx(i,t,e){let n=R("datalist",{id:"variables"}),s=R("input",{id:"variable",list:"variables",maxlength:32,size:12,spellcheck:"false",placeholder:"p1","aria-label":"Name of a place",pattern:"[a-z][a-z0-9\\-]*",title:"a letter, then letters, digits and hyphens"}),r=l=>()=>s.value&&s.reportValidity()&&e.send(`(${l} ${s.value})`),o=R("button",{type:"button",onclick:r("learn")},"Save"),a=R("button",{type:"button",onclick:r("goto")},"Go to");return i.follow("(robot-variable ?robot ?name ?joints)",l=>{let c=l.map(pt).filter(h=>j(h[1])===t.robot);n.replaceChildren(...c.map(h=>R("option",{value:j(h[2])})))}),{parts:[s,n,o,a],name:s,save:o,go:a}}function ex(i){let t=R("input",{id:"action",maxlength:4e3,spellcheck:"false",placeholder:"(move 350 0 300)   or   CIRCLE p1, p2, p3","aria-label":"Action"}),e=R("button",{type:"submit"},"Do action"),n=R("form",{class:"row"},t,e);return n.addEventListener("submit",s=>{s.preventDefault(),t.value&&i.send(Fe([Zt("do-action"),t.value]))}),{form:n,controls:[t,e]}}function nx(i,t,e){let n=R("span",{id:"service-light",class:"chip",role:"status"}),s=new Set,r=new Map,o=()=>s.has(t.robot)?r.has(t.robot)?`${r.get(t.robot)} released control: get it first`:"":"No robot is present",a=()=>{n.textContent=o()||"In service",n.className=`chip ${o()?"bad":"good"}`,e()};return i.followAlways("(agent ?name robot ?host)",l=>{s=new Set(l.map(c=>j(pt(c)[1]))),a()}),i.followAlways("(robot-released ?robot ?client)",l=>{r=new Map(l.map(c=>[j(pt(c)[1]),j(pt(c)[2])])),a()}),t.onChange(a),{light:n,why:o}}function ix(i,t,e,n){for(let s of t)s.dataset.title=s.title;return()=>{for(let s of t){let r=i.mine?e.has(s)?n():"":"Take the arm in hand first";s.disabled=r!=="",s.title=r||s.dataset.title}}}function sx(i){let t=R("span",{class:"quiet"}),e=R("button",{type:"button",id:"take-arm",class:"strong"},"Take the arm in hand");e.addEventListener("click",()=>i.toggle().catch(s=>t.textContent=Ae(s)));let n=R("button",{type:"button",id:"ask-for-arm",hidden:!0},"Ask for it");return n.addEventListener("click",()=>i.toggleWish().catch(s=>t.textContent=Ae(s))),i.onChange((s,r)=>{n.hidden=s||r==="",n.textContent=i.asking?"Ask no more":"Ask for it",e.textContent=s?"Let the arm go":r?`Take over from ${r}`:"Take the arm in hand",t.textContent=s?"Only you move the arm now.":r?i.asking?`${r} is asked for it.`:"":"Anybody may move the arm: a goal, a prompt."}),R("div",{class:"row"},e,n,t)}function Jd(i,t){let e=new Fr(i,()=>t.robot,()=>t.me,"Commands that the arm received, newest first"),n=A=>e.send(A),s=(A,M)=>R("button",{type:"button",onclick:()=>n(M)},A),r=[s("Home","(home)"),s("Ready","(ready)")],o=[s("Get control","(get-control)"),s("Release control","(release-control)")],a=[s("Monitor","(monitor)"),s("Finish: report","(finish report)"),s("Finish: stop","(finish stop)"),s("Status","(get-status)")],l=$d(i,t,e),c=J_.map(A=>ll(A,n)),h=Xo(K_,n),u=Xo(j_,n),f=tx(i,t,e),d=ex(e),m=[...r,...l.buttons,...[...c,h].map(A=>A.input),f.go,...d.controls],y=[...o,u.input,f.name,f.save],p=()=>{},{light:g,why:v}=nx(i,t,()=>p());p=ix(t,[...m,...y],new Set(m),v),Ut("drive").append(sx(t),R("div",{class:"row"},g,...o,...r),R("div",{class:"row"},...a),R("div",{class:"driving"},R("div",{},...l.parts),R("div",{class:"slides"},...c.map(A=>A.row),h.row,u.row)),R("div",{class:"row"},...f.parts,Q_(i,t)),d.form,R("h2",{},"Commands received"),e.list),p(),i.follow("(robot-speed ?robot ?percent)",A=>{let M=A.map(pt).find(P=>j(P[1])===t.robot);M&&u.put(M[2])}),i.follow("(gripper ?robot ?opening)",A=>{let M=A.map(pt).find(P=>j(P[1])===t.robot);M&&h.put(Math.round(M[2]))})}var cl=class{#e;#t=new Map;#n=[];constructor(t){this.#e=t,t.followAlways("(holder console ?role ?server ?state)",e=>{let n=e.map(pt).filter(([,,,,s])=>j(s)!=="absent");this.#t=new Map(n.map(([,,s,r])=>[j(s),j(r)]));for(let s of this.#n)s()})}server(t){return this.#t.get(t)??""}follow(t,e,n){let s=[],r=()=>{let o=this.server(t);n(o===""?s:s.filter(a=>j(a[1])===o))};this.#e.follow(e,o=>{s=o.map(pt),r()}),this.onChange(r)}onChange(t){this.#n.push(t)}};var rx={looking:"looking for boards",fitting:"fitting",done:"done",failed:"failed"},Or=3,ox=64,ax=32,lx=8192,hl={missing:"#4b3a17",grid:"#2a3b47",taken:"#7fd18b",now:"#f2a33a"};function Kd(i,t,e,n){let s=i.getContext("2d");s.strokeStyle=e,s.lineWidth=n,s.beginPath();for(let r=0;r+1<t.length;r+=2)s.lineTo(t[r],t[r+1]);s.closePath(),s.stroke()}function cx(i,t){let e=i.getContext("2d"),[n,s]=[i.width/Or,i.height/Or];e.clearRect(0,0,i.width,i.height),e.fillStyle=hl.missing;for(let[,r,o]of t)e.fillRect(r*n,o*s,n,s);e.strokeStyle=hl.grid,e.lineWidth=1;for(let r=0;r<Or*Or;++r)e.strokeRect(r%Or*n,Math.floor(r/Or)*s,n,s)}function jd(){let i=R("canvas",{role:"img"}),t=R("small",{});return{canvas:i,label:t,box:R("div",{class:"boards"},i,t)}}function Qd(i){let t=R("span",{class:"chip",id:"calibration-state",role:"status"}),e=R("span",{id:"calibration-count"}),n=R("p",{id:"calibration-sentence",hidden:!0}),s=R("span",{class:"quiet",id:"calibration-sees"}),r=R("ul",{id:"calibration-lacks","aria-label":"Still missing"}),o=[jd(),jd()],a=R("section",{id:"calibration","aria-label":"Calibration",hidden:!0},R("div",{class:"row"},R("h2",{},"Calibration"),t,e,s),n,R("div",{class:"calibrating"},...o.map(d=>d.box),r)),l,c=[],h=[],u=[],f=()=>{if(a.hidden=l===void 0,a.hidden)return;let[,d,m,y,p,g,v]=l,A=j(d);t.textContent=rx[A]??A,t.className=`chip ${{done:"good",failed:"bad"}[A]??"busy"}`,e.textContent=`${g} of ${v} boards`,n.textContent=Jt(j(m),1e3),n.hidden=n.textContent==="";let M=u.map(([,E])=>Jt(j(E)));r.replaceChildren(...(M.length?M:["nothing more"]).map(E=>R("li",{},E)));let P=c.some(E=>1 in E);o.forEach(({canvas:E,label:_,box:T},k)=>{let U=[y,p].every(C=>C>0&&C<=lx);if(T.hidden=!U||!c.some(C=>k in C),!T.hidden){_.textContent=`Boards in the ${P?["left ","right "][k]:""}image`,E.setAttribute("aria-label",_.textContent),Object.assign(E,{width:y,height:p}),cx(E,u.map(([,,C])=>C).filter(([C])=>C===k));for(let C of c)k in C&&Kd(E,C[k],hl.taken,2);k in h&&Kd(E,h[k],hl.now,4)}})};return i.follow("(calibration ?state ?sentence ?width ?height ?boards ?wanted)",d=>{l=d.length?pt(d[0]):void 0,f()}),i.follow("(calibration-board ?number ?outlines)",d=>{c=d.slice(0,ox).map(m=>pt(m)[2]),f()}),i.follow("(calibration-sees ?outlines ?sentence)",d=>{h=d.length?pt(d[0])[1]:[],s.textContent=d.length?`the newest image: ${Jt(j(pt(d[0])[2]))}`:"",f()}),i.follow("(calibration-lacks ?sentence ?part)",d=>{u=d.slice(0,ax).map(pt),f()}),a}var sr="end-effector",hx=["Area","Perimeter","NF","M0","M1","M2"],ul=class{#e=[];#t=new Map;#n=[];#i=[];constructor(t){let e=(n,s)=>t.follow("eyes",n,r=>{s(r),this.#s()});e("(learned ?eyes ?name ?num ?area ?perimeter ?nf ?m0 ?m1 ?m2)",n=>this.#e=n),e("(learned-template ?eyes ?name ?num ?tone ? ? ? ? ? ? ?picture)",n=>{this.#t=new Map(n.map(s=>[`${s[2]} ${s[3]}`,s]))}),e("(look-alike ?eyes ?name ?other ?error ?sentence)",n=>this.#n=n)}onChange(t){this.#i.push(t)}#s(){for(let t of this.#i)t()}names(){let t=[...new Set(this.#e.map(e=>j(e[2])))].sort();return t.includes(sr)?[sr,...t.filter(e=>e!==sr)]:t}samples(t){return this.#e.filter(e=>j(e[2])===t).map(e=>this.#r(e))}newest(t){return this.samples(t).reduce((e,n)=>!e||n.num>e.num?n:e,void 0)}alike(t){return this.#n.filter(e=>[j(e[2]),j(e[3])].includes(t)).map(e=>j(e[5]))}#r(t){let e=this.#t.get(`${t[2]} ${t[3]}`),n=t.slice(4).map((s,r)=>[hx[r],Number.isInteger(s)?s:s.toFixed(3)]);return{num:t[3],parameters:n,picture:e?j(e.at(-1)):"",tone:e?j(e[4]):"dark"}}};var Br=32;function fl(i,t,e){let n=R("canvas",{class:"template",width:Br,height:Br,role:"img","aria-label":e});if(!/^[0-9a-f]{1024}$/.test(i))return n;let s=n.getContext("2d"),r=s.createImageData(Br,Br);for(let o=0;o<Br*Br;++o){let a=parseInt(i[o],16)/15,l=Math.round(255*(t==="light"?a:1-a));r.data.set([l,l,l,255],4*o)}return s.putImageData(r,0,0),n}var ux=[sr,"circle","triangle","square","cross"],fx=i=>/^\(LEARN ".*" OK\)$/.test(i[0]??""),dl=class{#e;#t;#n;#i;#s=!1;#r=null;panel=R("div",{class:"teaching"});training=R("button",{type:"button",id:"training","aria-pressed":"false"},"Training: off");#o=R("p",{class:"quiet",id:"teach-hint",role:"status"});#a=R("input",{id:"learn-name",list:"learned-names",maxlength:64,spellcheck:"false",placeholder:"a name, or none yet",pattern:"[A-Za-z][A-Za-z0-9\\-]*",title:"a letter, then letters, digits and hyphens"});#c=R("datalist",{id:"learned-names"});#u=R("div",{class:"learned-sample"});#f=R("div",{class:"learned-window",id:"learned-window",role:"group",hidden:!0});constructor({ask:t,objects:e,provisional:n,why:s}){this.#e=t,this.#t=e,this.#n=n,this.#i=s,this.training.addEventListener("click",()=>this.#p(!this.#d)),this.panel.append(R("div",{class:"row"},this.training,R("label",{for:"learn-name"},"Name"),this.#a),this.#c,this.#o,this.#f),e.onChange(()=>{this.#_(),this.#s||this.#g()}),this.#_()}get#d(){return this.training.getAttribute("aria-pressed")==="true"}#p(t){this.training.setAttribute("aria-pressed",String(t)),this.training.textContent=`Training: ${t?"on":"off"}`,document.body.classList.toggle("training",t),this.#_()}#h(t){this.#o.textContent=t}#_(){let t=this.#t.names().filter(n=>n!==this.#n());if(this.#c.replaceChildren(...t.map(n=>R("option",{value:n}))),this.#s)return;let e=t.includes(sr)?"":" Begin with the end-effector: the triangle on the gripper.";this.#h(this.#d?`Click on a mark in the camera\u2019s image.${e}`:"Switch training on, and click on a mark."),this.#d&&e&&this.#a.value===""&&(this.#a.value=sr)}more(t){this.#p(!0),this.#a.value=t}take(t){return this.#d?(this.#s||!this.#a.reportValidity()||this.#M(t,this.#a.value||this.#n()),!0):!1}#l(t){return this.#t.newest(t)?.num??0}async#M(t,e){this.#s=!0,this.#f.hidden=!0,this.#h(`Learning what is at ${t.x}, ${t.y} of frame ${t.frame}: red while it is filled, then its border.`);let n=this.#l(e);try{let s=await this.#e(Zt("learn"),t.x,t.y,t.frame,e);if(!fx(s))throw{said:`${s[0]??"FAIL"}: ${await this.#i(s[0]??"")}`};this.#r={name:e,before:n},this.#x(e)}catch(s){this.#h(`${Ae(s)}. For one more sample of an object write its name first; then click again.`)}this.#s=!1}#x(t){let e=t===this.#n(),n=R("input",{id:"new-name",required:!0,maxlength:64,spellcheck:"false",pattern:"[A-Za-z][A-Za-z0-9\\-]*",title:"a letter, then letters, digits and hyphens",value:e?"":t}),s=this.#t.names(),r=l=>R("button",{type:"button",class:"small",onclick:()=>n.value=l},l),o=e?ux.filter(l=>!s.includes(l)).map(r):[],a=R("form",{class:"row"},R("label",{for:"new-name"},"Name it"),n,...o,R("button",{type:"submit",class:"strong"},"Accept"),R("button",{type:"button",id:"reject",onclick:()=>this.#S()},"Reject"));a.addEventListener("submit",l=>{l.preventDefault(),this.#v(n.value)}),this.#f.replaceChildren(this.#u,a),this.#g(),this.#f.hidden=!1,this.#h("Learned. Accept it under a name, or reject it."),n.focus()}#g(){if(!this.#r||this.#l(this.#r.name)<=this.#r.before)return this.#u.replaceChildren();let{name:t}=this.#r,e=this.#t.newest(t),s=[["Name",t===this.#n()?"to be named":t],...e.parameters,["Num",e.num]];this.#u.replaceChildren(fl(e.picture,e.tone,`What was learned as ${t}`),R("dl",{class:"parameters"},...s.flatMap(([r,o])=>[R("dt",{},r),R("dd",{},String(o))])),...this.#t.alike(t).map(r=>R("p",{class:"warn"},Jt(r))))}async#y(t,e,n){if(this.#s)return;this.#s=!0,this.#h(t);let s=n;try{await e(),this.#r=null,this.#f.hidden=!0,this.#a.value=""}catch(r){s=Ae(r)}this.#s=!1,this.#_(),this.#h(s)}#v(t){let e=this.#r.name,n=async()=>{t!==e&&await this.#e(Zt("rename"),e,t),this.#r={name:t,before:0},await this.#e(Zt("accept"),t)};return this.#y(`Accepting ${t} \u2026`,n,`${t} is accepted. Click on the next mark.`)}#S(){return this.#y("Rejecting \u2026",()=>this.#e(Zt("reject"),this.#r.name),"Rejected: nothing was learned.")}};function dx(i,t,e){let n="no eyes are present";if(!i)return{train:n,forget:n,track:n,end:n};let s=c=>t.filter(([,h])=>h===c).map(([h])=>h),r=s("tracking"),o=s("learning"),a=r.length?`${r.join(", ")} tracks, which excludes learning: end that first`:"",l=o.length?`${o[0]} is learning`:"";return{train:a||(o.includes(e)?"":l),forget:a||l,track:l,end:r.includes(e)?"":r.length?`${r[0]} tracks, and ends it itself`:"nothing is tracked"}}function rr(i,t){i.disabled=t!=="",i.title=t}function tp(i,t,e,n){let s=Ut("eyes"),r=R("pre",{class:"answer",id:"eyes-answer",role:"status",hidden:!0}),o=R("span",{id:"eyes-mode",class:"chip"},"no eyes"),a=R("span",{class:"quiet"}),l=R("pre",{class:"answer","aria-label":"What TRACK says",hidden:!0}),c=new ul(e),h="vision",u=!1,f=[],d=(...C)=>i.request(h,C),m=async C=>{let F=await i.ask([Zt("vision-failed"),Zt(h),Zt("?"),C,Zt("?"),Zt("?sentence")]);return F.length?j(pt(F[0])[5]):"no reason was told"},y=async(...C)=>{r.hidden=!1,r.textContent="\u2026";try{let F=await d(...C),G=/ FAIL\)/.test(F[0]??"")?`
${await m(F[0])}`:"";r.textContent=Jt((F.join(`
`)||"ok")+G,2e3)}catch(F){r.textContent=Ae(F)}},p=(C,...F)=>R("button",{type:"button",onclick:()=>y(...F)},C),g=p("Connect",Zt("connect")),v=p("Disconnect",Zt("disconnect")),A=p("End track",Zt("end-track")),M=new dl({ask:d,objects:c,provisional:()=>`unnamed-${n().replace(/\D+/g,"-").replace(/^-/,"")}`,why:m});t.onPoint(C=>M.take(C));let P=R("ul",{class:"objects","aria-label":"Learned objects"});s.append(Qd(i),R("div",{class:"row"},o,a),R("div",{class:"row"},g,v,A),M.panel,r,l,P);let E=new Map,_=new Map,T=()=>{for(let[C,{state:F}]of _){let G=E.get(C);F.textContent=G?`${j(G[3])}, ${(G[5]*100).toFixed(0)} %`:"not tracked"}},k=C=>{let F=c.samples(C),G=JSON.stringify([F,c.alike(C)]);if(_.get(C)?.of===G)return _.get(C);let D=R("span",{}),V=p("Track",Zt("track"),C),$=p("Forget",Zt("forget"),C),H=R("button",{type:"button",onclick:()=>M.more(C)},"Add sample"),ct=c.alike(C).map(Q=>R("small",{class:"warn"},Jt(Q,160))),J=R("li",{},R("span",{class:"templates"},...F.map(Q=>fl(Q.picture,Q.tone,`Sample ${Q.num} of ${Jt(C,64)}`))),R("span",{},R("strong",{},Jt(C,64)),R("span",{class:"quiet"},` ${F.length} sample${F.length>1?"s":""}; `,D),...ct),p("Find",Zt("find"),C),V,H,$);return _.set(C,{of:G,item:J,state:D,more:H,track:V,forget:$}),_.get(C)},U=()=>{let C=dx(u,f,n()),F=f.some(([V,$])=>V===n()&&$==="connected");rr(g,u?F?"you are connected":"":"no eyes are present"),rr(v,F?"":"you are not connected"),rr(A,C.end),rr(M.training,C.train),a.textContent=f.map(([V,$])=>`${V}: ${$}`).join(", ");let G=c.names().slice(0,64);for(let V of _.keys())G.includes(V)||_.delete(V);let D=G.map(k);for(let{more:V,track:$,forget:H}of D)rr(V,C.train),rr($,C.track),rr(H,C.forget);Fd(P,D.map(({item:V})=>V)),T()};c.onChange(U),e.follow("eyes","(vision-mode ?eyes ?mode ?connected)",([C])=>{u=!!C,h=C?j(C[1]):h;let F=C?j(C[2]):"no eyes";o.textContent=C?`${h}: ${F}`:F,o.className=`chip ${u?F==="idle"?"":"busy":"bad"}`,document.body.dataset.eyes=F,U()}),e.follow("eyes","(vision-held ?eyes ?client ?mode)",C=>{f=C.map(F=>[j(F[2]),j(F[3])]),U()}),e.follow("eyes","(tracked ?eyes ?name ?state ?frame ?confidence)",C=>{E.clear();for(let F of C)E.set(j(F[2]),F);T()}),e.follow("eyes","(look ?eyes ?frame ?text ?of)",([C])=>{l.hidden=!C,C&&(l.textContent=Jt(j(C[3]),1e3))})}var px=4,mx=60,gx=i=>pt(i)[2].filter(t=>Array.isArray(t)&&j(t[0])==="posts").flatMap(t=>t.slice(1)).filter(t=>Array.isArray(t?.[2]));async function _x(i){let t=await i.ask([Zt("contract"),Zt("?"),Zt("?form")]),e=new Map(t.flatMap(gx).map(([,s,r])=>[j(s),r.length])),n=new Map;for(let[s,r]of e){let o=await i.ask([Zt(s),...Array(r).fill(Zt("?"))]);for(let{ids:a,facts:l}of o)n.set(a[0],l[0])}return n}function xx(i,t){return t?R("span",{class:"fact"},R("code",{},Jt(t.text,120)),R("small",{class:"quiet"},`fact ${i}, by ${t.teller} at ${tn(t.when)}`)):R("span",{class:"fact gone"},`fact ${i}, which is not there any more`)}function ep(i,t,e,n,s){n.push(i);let o=(t&&s<px?t.because:[]).slice(0,Math.max(0,mx-n.length)).map(l=>ep(l,e.get(l),e,n,s+1)),a=o.length?R("ul",{"aria-label":"because of"},...o):null;return R("li",{},xx(i,t),a)}async function nu(i,t,e){let n=await _x(i);return R("ul",{class:"provenance","aria-label":"Because of what it was told"},ep(t,e,n,[],0))}function np(i,t,e){if(e.because.length===0)return null;let n=R("div",{}),s=`Because of ${e.because.length} fact${e.because.length>1?"s":""}`,r=R("button",{type:"button",class:"because"},s);return r.addEventListener("click",async()=>{r.disabled=!0,n.replaceChildren(await nu(i,t,e)),r.disabled=!1}),R("div",{},r,n)}var kr=(i,{teller:t,when:e})=>`fact ${i}, told by ${t} at ${tn(e)}`;var yx=60,vx=["Relation","Facts","Told/s","Watches","To board","To watcher","Told by"],ip=i=>i?`${i.p50} / ${i.p99}`:"\u2013";function Sx({revision:i,facts:t,transactions_per_second:e,journey:n}){let s=n?`; a fact is committed after ${n.committed_us} \xB5s, acknowledged after ${n.acknowledged_us} \xB5s, delivered after ${n.delivered_us} \xB5s`:"";return`revision ${i}, ${t} facts, ${e.toFixed(1)} transactions/s${s}`}function sp(i,t,e){let n=R("p",{class:"quiet",id:"activity-note"},"\u2026"),s=fs({id:"relations"},vx),r=new Map,o=c=>(r.has(c)||r.set(c,R("button",{type:"button",class:"small",onclick:()=>e(c)},c)),r.get(c).disabled=!t(c),r.get(c)),a=(c,h)=>{if(!c)return n.textContent=h;n.textContent=Sx(c);let u=c.relations.filter(f=>f.facts||f.told_per_second||f.watches).slice(0,yx);s.fill(u.toSorted((f,d)=>f.name.localeCompare(d.name)).map(f=>[o(f.name),f.facts,f.told_per_second.toFixed(1),f.watches,ip(f.told_us),ip(f.delivered_us),f.tellers.join(" ")]))},l=R("section",{"aria-label":"Relations"},R("h2",{},"Relations"),n,R("p",{class:"quiet"},"Under way to the board and from there, in \xB5s: the half / 99 %."),R("div",{class:"scroll",tabindex:0,role:"group","aria-label":"Table of relations"},s.panel));return i.shownIn(l,a),l}var pl=200,Mx=i=>`(${j(i[1])}${i[2].map(t=>` ?${j(t[0])}`).join("")})`;function bx(i,t){if(i.length===0)return R("p",{class:"quiet"},"nothing, now");let e=Object.keys(i[0].bindings),n=R("tr",{},...(e.length?e:["fact"]).map(r=>R("th",{},r)),R("td",{})),s=i.slice(0,pl).map(r=>{let o=r.facts.map((l,c)=>kr(r.ids[c],l)),a=e.length?e.map(l=>r.bindings[l]??""):[r.facts[0]?.text??"yes"];return R("tr",{title:o.join(`
`),class:t(r)?"new":""},...a.map(l=>R("td",{},Jt(l,160))),R("td",{},R("button",{type:"button",class:"because","data-ids":r.ids.join()},"Because \u2026")))});return R("table",{},R("thead",{},n),R("tbody",{},...s))}function rp(i,t){let e=R("input",{id:"query",spellcheck:"false",list:"questions",placeholder:"(on ?x ?y)","aria-label":"Question"}),n=R("datalist",{id:"questions"}),s=R("span",{class:"quiet",id:"query-count"}),r=R("pre",{class:"answer bad",id:"query-wrong",hidden:!0}),o=R("div",{class:"scroll",id:"answers"}),a=R("form",{class:"row"},e,n,R("button",{type:"submit",class:"strong"},"Watch"),s),l=R("div",{id:"because",role:"group","aria-label":"Reasons",tabindex:0,hidden:!0}),c=new Map,h=sp(t,m=>c.has(m),m=>{e.value=c.get(m),a.requestSubmit()});Ut("facts").append(a,r,l,o,h);let u=[],f=async m=>{let y=m.target.closest?.("button.because")?.dataset.ids,p=u.find(v=>v.ids.join()===y);if(!p)return;let g=p.facts.map((v,A)=>nu(i,p.ids[A],v));l.replaceChildren(...await Promise.all(g)),l.hidden=!1};o.addEventListener("pointerdown",f),o.addEventListener("keydown",m=>["Enter"," "].includes(m.key)&&f(m));let d=()=>{};a.addEventListener("submit",m=>{m.preventDefault(),d(),r.hidden=!0,s.textContent="",o.replaceChildren(),l.hidden=!0;let y=[],p=0,g=new Set,v=ni(()=>{let A=y.length+p>pl?`, ${pl} shown`:"";s.textContent=`${y.length+p} answer${y.length+p===1?"":"s"}${A}`,u=y;let M=g;g=new Set(y.slice(0,pl).map(P=>P.ids.join())),o.replaceChildren(bx(y,P=>M.size>0&&!M.has(P.ids.join())))});d=i.watch(e.value,(A,M)=>{y=A,p=M.resynchronised?M.cut:p+M.cut,v()},A=>{r.hidden=!1,r.textContent=Ae(A)})}),i.follow("(contract ?name ?form)",m=>{let p=m.flatMap(g=>pt(g)[2]).filter(g=>Array.isArray(g)&&j(g[0])==="posts").flatMap(g=>g.slice(1)).filter(g=>Array.isArray(g?.[2]));c.clear();for(let g of p)c.set(j(g[1]),Mx(g));n.replaceChildren(...[...c.values()].sort().map(g=>R("option",{value:g})))})}function op(i){let t=Ut("hands-note"),e=R("span",{}),n=R("button",{type:"button"});t.append(e,n);let s=()=>{};n.addEventListener("click",()=>s());let r=(c,h,u)=>{t.hidden=c==="",e.textContent!==c&&(e.textContent=c),n.textContent=h,s=u},o=()=>i.toggle().catch(c=>e.textContent=Ae(c)),a=()=>{i.change=null,l()},l=()=>{let{change:c,mine:h}=i,[u]=i.askers;return c&&c.from===i.me?r(`${c.to} has taken the arm over.`,"OK",a):h&&u?r(`${u} asks for the arm.`,`Let ${u} have it`,o):c&&h?r(`You have taken the arm over from ${c.from}, who is told.`,"OK",a):r("","",()=>{})};i.onChange(l)}var ap=[{name:"pan",label:"Pan left / right",index:1},{name:"tilt",label:"Tilt down / up",index:2}];function wx({name:i,label:t},e){let n=ll({label:t,unit:"\xB0",most:30,form:c=>`(set-${i}-rel-pos ${c})`},e),s=Xo({label:`${t.split(" ")[0]} speed`,unit:"%",least:1,most:100,value:20,form:c=>`(set-${i}-speed ${c})`},e),r=R("input",{type:"number",id:`${i}-place`,step:"any",required:!0,size:6,"aria-label":`${i} to, degrees`}),o=R("button",{type:"submit"},"Move to"),a=R("button",{type:"button",onclick:()=>e(`(reset-${i})`)},`Reset ${i}`),l=R("form",{class:"row"},R("label",{for:r.id},i),r,"\xB0",o,a);return l.addEventListener("submit",c=>{c.preventDefault(),e(`(set-${i}-pos ${Number(r.value)})`)}),{rows:[n.row,s.row],form:l,percent:s,controls:[n.input,s.input,r,o,a]}}function Tx(i,t){let[,,,,e,n,s]=i,r=o=>Math.atan(o/e)*180/Math.PI;return{pan:r(t.x-n),tilt:-r(t.y-s)}}function lp(i,t,e){let n=Ut("head"),s=new Fr(i,()=>"pan-tilt",e,"Commands that the head received, newest first"),r=p=>s.send(p),o=R("span",{id:"head-light",class:"chip"},"no head"),a=R("output",{"aria-label":"Where the head looks"},""),l=ap.map(p=>wx(p,r)),c=(p,g)=>R("button",{type:"button",onclick:()=>r(g)},p),h=[c("Connect","(pt-init)"),c("Disconnect","(pt-close)"),c("Reset both","(reset-all)"),c("Look ahead","(look-ahead)")],u=R("input",{type:"checkbox",id:"click-to-look"}),f=[...h,u,...l.flatMap(p=>p.controls)];n.append(R("div",{class:"row"},o,a,...h),R("div",{class:"slides"},...l.flatMap(p=>p.rows)),...l.map(p=>p.form),R("label",{class:"row"},u,"A click in the camera\u2019s image turns the head there"),R("h2",{},"Commands received"),s.list);let d,m;t.onPoint(p=>{if(!u.checked||!d||!m)return!1;let g=Tx(m,p);return r(`(set-pan-pos ${(d[1]+g.pan).toFixed(2)})`),r(`(set-tilt-pos ${(d[2]+g.tilt).toFixed(2)})`),!0}),i.follow("(head ?pan ?tilt ?state)",p=>{d=p.length?pt(p[0]):void 0,a.textContent=d?`pan ${d[1].toFixed(1)}\xB0, tilt ${d[2].toFixed(1)}\xB0, ${j(d[3])}`:""}),i.follow("(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)",p=>{let g=p.length?pt(p[0]):void 0;m=g&&[...g]});let y=p=>{let g=p?j(p[1]):"no head";o.textContent=p&&j(p[2])?`${g}: ${j(p[2])}`:g,o.className=`chip ${g==="ready"?"good":"bad"}`;for(let v of f)v.disabled=!p,v.title=p?"":"This cell has no head that turns, or its agent is away"};y(),i.follow("(pan-tilt ?state ?trouble)",p=>y(p.length?pt(p[0]):void 0)),i.follow("(head-speed ?pan ?tilt)",p=>{p.length&&ap.forEach((g,v)=>l[v].percent.put(pt(p[0])[g.index]))})}function cp(i){let t=location.protocol==="https:";Ut("refused-here").hidden=t,Ut("log-in").hidden=!t,Ut("log-out").hidden=!t,Ut("log-out").addEventListener("click",()=>i.logOut());let e=!1;return Ut("log-in").addEventListener("submit",n=>{n.preventDefault(),e=!0,Ut("log-in-wrong").textContent="",i.logIn(Ut("token").value.trim()),Ut("token").value=""}),n=>{n==="live"&&Ut("refused").close(),n==="refused"&&e&&(Ut("log-in-wrong").textContent="This token is wrong."),n==="refused"&&!Ut("refused").open&&Ut("refused").showModal()}}var Ex={closed:"the camera is closed: Connect, in Eyes, opens it",opening:"the camera opens",lost:"the camera is lost"},hp=[{kinds:["colour","left"],title:"Camera"},{kinds:["annotated"],title:"What the eyes follow"}];function Ax(i){let t=R("canvas",{width:640,height:480,role:"img","aria-label":i}),e=R("span",{class:"quiet"},"no image yet"),n=R("figure",{class:"card"},t,R("figcaption",{},R("span",{},i),e));return{canvas:t,note:e,card:n,stream:"",shown:null,end:()=>{}}}function ml(i,t){(i.width!==t.width||i.height!==t.height)&&(i.width=t.width,i.height=t.height),i.getContext("2d").drawImage(t.bitmap,0,0,t.width,t.height)}function Cx(i,t){let{canvas:e}=i;ml(e,t),i.shown={number:t.number,width:t.width,height:t.height},i.note.textContent=`frame ${t.number}`,e.dataset.captured=t.captured,e.dataset.frame=t.number}async function Rx(i,t,e,n){t.shown=null,t.note.textContent="looking for what was kept \u2026";try{let s=await i.picture(t.stream,e);n()&&(ml(t.canvas,s),t.note.textContent=`frame ${s.number}, ${tn(s.captured)}`),s.bitmap.close()}catch(s){if(!n())return;t.canvas.getContext("2d").clearRect(0,0,t.canvas.width,t.canvas.height),t.note.textContent=Ae(s)}}function Px(i,t){let{width:e,height:n,number:s}=i.shown,r=i.canvas.getBoundingClientRect(),o=Math.min(r.width/e,r.height/n),a=Math.round((t.clientX-r.left-(r.width-o*e)/2)/o),l=Math.round((t.clientY-r.top-(r.height-o*n)/2)/o);return a>=0&&l>=0&&a<e&&l<n?{x:a,y:l,frame:s}:null}function up(i,t){let e=hp.map(u=>Ax(u.title));Ut("images").append(...e.map(u=>u.card));let n=null,s=[],r=u=>{let f=s.filter(d=>j(d[2])===u).map(d=>j(d[1]));return f.find(d=>d===`${t.server("eyes")}-${u}`)??f[0]},o=()=>hp.forEach((u,f)=>{let d=e[f],m=u.kinds.map(r).find(Boolean)??"";m!==d.stream&&(d.end(),d.stream=m,d.canvas.dataset.stream=m,d.end=m?i.look(m,y=>n===null&&Cx(d,y)):()=>{},m||(d.note.textContent="no such stream"))});i.followAlways("(stream ?name ?kind ?place)",u=>{s=u.map(pt),o()}),t.onChange(o),i.followAlways("(camera-state ?eyes ?state ?trouble)",u=>{let f=u.map(pt),[,,d,m]=f.find(g=>j(g[1])===t.server("eyes"))??f[0]??[],y=d===void 0?"no eyes are present":Ex[j(d)];if(!y||n!==null)return;let p=Jt([y,j(m??"")].filter(Boolean).join(": "),120);for(let g of e)g.note.textContent=p});let a=[],[l]=e;return l.canvas.classList.add("clickable"),l.canvas.addEventListener("click",u=>{let f=l.shown&&Px(l,u);f&&a.some(d=>d(f))}),{onPoint:u=>a.push(u),showMoment:u=>{n=u;let f=()=>n===u;for(let d of e)u!==null&&d.stream&&Rx(i,d,u,f)},telling:()=>e[1].stream||e[0].stream}}function fp(i,t){let e=Ut("past"),n=R("input",{type:"range",id:"moment",min:0,max:1e3,value:1e3,disabled:!0,"aria-label":"Back in time"}),s=R("output",{id:"moment-note",for:"moment"},"now"),r=R("button",{type:"button",id:"back-to-now",disabled:!0},"Now");e.append(R("label",{for:"moment"},"Time"),n,s,r);let o=0,a=()=>Math.round(o+(Date.now()*1e3-o)*Number(n.value)/1e3),l=async h=>{document.body.classList.toggle("past",h!==null),r.disabled=h===null,s.textContent=h===null?"now":`${tn(h)} \u2026`,t.showMoment(h);let u=await i.showMoment(h);h!==null&&(s.textContent=u?Ae(u):`as it was at ${tn(h)}`)};n.addEventListener("input",()=>s.textContent=tn(a())),n.addEventListener("change",()=>l(Number(n.value)===1e3?null:a())),r.addEventListener("click",()=>{n.value=1e3,l(null)});let c=h=>{for(let{facts:u}of h)o=o?Math.min(o,u[0].when):u[0].when;n.disabled=o===0};return i.followAlways("(agent ?name ?kind ?host)",c),i.followAlways("(event ?n ?kind ?sentence ?detail)",c),h=>{n.value=(h-o)*1e3/(Date.now()*1e3-o),l(h)}}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var $s={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ys={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Wp=0,Du=1,Xp=2;var La=1,qp=2,_o=3,Zs=0,ti=1,ii=2,fr=0,xo=1,Nu=2,Uu=3,Fu=4,$p=5;var dr=100,Yp=101,Zp=102,Jp=103,Kp=104,jp=200,Qp=201,tm=202,em=203,Ou=204,Bu=205,nm=206,im=207,sm=208,rm=209,om=210,am=211,lm=212,cm=213,hm=214,ql=0,$l=1,Yl=2,ro=3,Zl=4,Jl=5,Kl=6,jl=7,ku=0,um=1,fm=2,ns=0,zu=1,Vu=2,Gu=3,Hu=4,Wu=5,Xu=6,qu=7;var $u=300,pr=301,yo=302,Tc=303,Ec=304,Ql=1e3,Ki=1001,tc=1002,Dn=1003,dm=1004;var Da=1005;var Kn=1006,Ac=1007;var ws=1008;var si=1009,Yu=1010,Zu=1011,vo=1012,Cc=1013,Ui=1014,Fi=1015,Oi=1016,Rc=1017,Pc=1018,mr=1020,Ju=35902,Ku=35899,ju=1021,Qu=1022,Bi=1023,ys=1026,Ts=1027,tf=1028,Ic=1029,Js=1030,Lc=1031;var Dc=1033,Na=33776,Ua=33777,Fa=33778,Oa=33779,Nc=35840,Uc=35841,Fc=35842,Oc=35843,Bc=36196,kc=37492,zc=37496,Vc=37488,Gc=37489,Ba=37490,Hc=37491,Wc=37808,Xc=37809,qc=37810,$c=37811,Yc=37812,Zc=37813,Jc=37814,Kc=37815,jc=37816,Qc=37817,th=37818,eh=37819,nh=37820,ih=37821,sh=36492,rh=36494,oh=36495,ah=36283,lh=36284,ka=36285,ch=36286;var ia=2300,ec=2301,Wl=2302,Eu=2303,Au=2400,Cu=2401,Ru=2402;var pm=3200;var hh=0,mm=1,Es="",Zn="srgb",sa="srgb-linear",ra="linear",Ie="srgb";var Xl=7680;var gm=519,_m=512,xm=513,ym=514,ef=515,vm=516,Sm=517,nf=518,sf=519,rf=35044;var of="300 es",Mi=2e3,oo=2001;function Ix(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Lx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function oa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Mm(){let i=oa("canvas");return i.style.display="block",i}var dp={},ao=null;function aa(...i){let t="THREE."+i.shift();ao?ao("log",t,...i):console.log(t,...i)}function bm(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function jt(...i){i=bm(i);let t="THREE."+i.shift();if(ao)ao("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function ie(...i){i=bm(i);let t="THREE."+i.shift();if(ao)ao("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function ea(...i){let t=i.join(" ");t in dp||(dp[t]=!0,jt(...i))}function wm(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Tm={[ql]:ql,[Yl]:Kl,[Zl]:Zl,[ro]:Jl,[$l]:$l,[Kl]:Yl,[jl]:jl,[Jl]:ro},Ni=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],pp=1234567,io=Math.PI/180,lo=180/Math.PI;function Ks(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(zn[i&255]+zn[i>>8&255]+zn[i>>16&255]+zn[i>>24&255]+"-"+zn[t&255]+zn[t>>8&255]+"-"+zn[t>>16&15|64]+zn[t>>24&255]+"-"+zn[e&63|128]+zn[e>>8&255]+"-"+zn[e>>16&255]+zn[e>>24&255]+zn[n&255]+zn[n>>8&255]+zn[n>>16&255]+zn[n>>24&255]).toLowerCase()}function xe(i,t,e){return Math.max(t,Math.min(e,i))}function af(i,t){return(i%t+t)%t}function Dx(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Nx(i,t,e){return i!==t?(e-i)/(t-i):0}function na(i,t,e){return(1-e)*i+e*t}function Ux(i,t,e,n){return na(i,t,1-Math.exp(-e*n))}function Fx(i,t=1){return t-Math.abs(af(i,t*2)-t)}function Ox(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function Bx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function kx(i,t){return i+Math.floor(Math.random()*(t-i+1))}function zx(i,t){return i+Math.random()*(t-i)}function Vx(i){return i*(.5-Math.random())}function Gx(i){i!==void 0&&(pp=i);let t=pp+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Hx(i){return i*io}function Wx(i){return i*lo}function Xx(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function qx(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function lf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function $x(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),f=o((t-n)/2),d=r((n-t)/2),m=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*m,l*d,a*c);break;case"YXY":i.set(l*d,a*h,l*m,a*c);break;case"ZYZ":i.set(l*m,l*d,a*h,a*c);break;default:jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function uh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function cf(i,t){if(t.constructor===Float32Array)return i;let e=uh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function hf(i,t){if(t.constructor===Float32Array)return i;let e=uh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var uf={DEG2RAD:io,RAD2DEG:lo,generateUUID:Ks,clamp:xe,euclideanModulo:af,mapLinear:Dx,inverseLerp:Nx,lerp:na,damp:Ux,pingpong:Fx,smoothstep:Ox,smootherstep:Bx,randInt:kx,randFloat:zx,randFloatSpread:Vx,seededRandom:Gx,degToRad:Hx,radToDeg:Wx,isPowerOfTwo:Xx,ceilPowerOfTwo:qx,floorPowerOfTwo:lf,setQuaternionFromProperEuler:$x,normalize:hf,denormalize:cf},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(xe(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},jn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],d=r[o+1],m=r[o+2],y=r[o+3];if(u!==y||l!==f||c!==d||h!==m){let p=l*f+c*d+h*m+u*y;p<0&&(f=-f,d=-d,m=-m,y=-y,p=-p);let g=1-a;if(p<.9995){let v=Math.acos(p),A=Math.sin(v);g=Math.sin(g*v)/A,a=Math.sin(a*v)/A,l=l*g+f*a,c=c*g+d*a,h=h*g+m*a,u=u*g+y*a}else{l=l*g+f*a,c=c*g+d*a,h=h*g+m*a,u=u*g+y*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],d=r[o+2],m=r[o+3];return t[e]=a*m+h*u+l*d-c*f,t[e+1]=l*m+h*f+c*u-a*d,t[e+2]=c*m+h*d+a*f-l*u,t[e+3]=h*m-a*u-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),d=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*d*m,this._y=c*d*u-f*h*m,this._z=c*h*m+f*d*u,this._w=c*h*u-f*d*m;break;case"YXZ":this._x=f*h*u+c*d*m,this._y=c*d*u-f*h*m,this._z=c*h*m-f*d*u,this._w=c*h*u+f*d*m;break;case"ZXY":this._x=f*h*u-c*d*m,this._y=c*d*u+f*h*m,this._z=c*h*m+f*d*u,this._w=c*h*u-f*d*m;break;case"ZYX":this._x=f*h*u-c*d*m,this._y=c*d*u+f*h*m,this._z=c*h*m-f*d*u,this._w=c*h*u+f*d*m;break;case"YZX":this._x=f*h*u+c*d*m,this._y=c*d*u+f*h*m,this._z=c*h*m-f*d*u,this._w=c*h*u-f*d*m;break;case"XZY":this._x=f*h*u-c*d*m,this._y=c*d*u-f*h*m,this._z=c*h*m+f*d*u,this._w=c*h*u+f*d*m;break;default:jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=n+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>u){let d=2*Math.sqrt(1+n-a-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-n-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(xe(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(mp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(mp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return iu.copy(this).projectOnVector(t),this.sub(iu)}reflect(t){return this.sub(iu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(xe(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},iu=new X,mp=new jn,re=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],d=n[5],m=n[8],y=s[0],p=s[3],g=s[6],v=s[1],A=s[4],M=s[7],P=s[2],E=s[5],_=s[8];return r[0]=o*y+a*v+l*P,r[3]=o*p+a*A+l*E,r[6]=o*g+a*M+l*_,r[1]=c*y+h*v+u*P,r[4]=c*p+h*A+u*E,r[7]=c*g+h*M+u*_,r[2]=f*y+d*v+m*P,r[5]=f*p+d*A+m*E,r[8]=f*g+d*M+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,d=c*r-o*l,m=e*u+n*f+s*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return t[0]=u*y,t[1]=(s*c-h*n)*y,t[2]=(a*n-s*o)*y,t[3]=f*y,t[4]=(h*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=d*y,t[7]=(n*l-c*e)*y,t[8]=(o*e-n*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ea("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(su.makeScale(t,e)),this}rotate(t){return ea("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(su.makeRotation(-t)),this}translate(t,e){return ea("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(su.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},su=new re,gp=new re().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),_p=new re().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Yx(){let i={enabled:!0,workingColorSpace:sa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ie&&(s.r=xs(s.r),s.g=xs(s.g),s.b=xs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ie&&(s.r=so(s.r),s.g=so(s.g),s.b=so(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Es?ra:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[sa]:{primaries:t,whitePoint:n,transfer:ra,toXYZ:gp,fromXYZ:_p,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Zn},outputColorSpaceConfig:{drawingBufferColorSpace:Zn}},[Zn]:{primaries:t,whitePoint:n,transfer:Ie,toXYZ:gp,fromXYZ:_p,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Zn}}}),i}var Se=Yx();function xs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function so(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var zr,nc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{zr===void 0&&(zr=oa("canvas")),zr.width=t.width,zr.height=t.height;let s=zr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=zr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=oa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=xs(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(xs(e[n]/255)*255):e[n]=xs(e[n]);return{data:e,width:t.width,height:t.height}}else return jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Zx=0,co=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Zx++}),this.uuid=Ks(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ru(s[o].image)):r.push(ru(s[o]))}else r=ru(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function ru(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?nc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(jt("Texture: Unable to serialize Texture."),{})}var Jx=0,ou=new X,Qn=class i extends Ni{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Ki,s=Ki,r=Kn,o=ws,a=Bi,l=si,c=i.DEFAULT_ANISOTROPY,h=Es){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Jx++}),this.uuid=Ks(),this.name="",this.source=new co(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new re,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ou).x}get height(){return this.source.getSize(ou).y}get depth(){return this.source.getSize(ou).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==$u)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ql:t.x=t.x-Math.floor(t.x);break;case Ki:t.x=t.x<0?0:1;break;case tc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ql:t.y=t.y-Math.floor(t.y);break;case Ki:t.y=t.y<0?0:1;break;case tc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Qn.DEFAULT_IMAGE=null;Qn.DEFAULT_MAPPING=$u;Qn.DEFAULT_ANISOTROPY=1;var je=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],m=l[9],y=l[2],p=l[6],g=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-y)<.01&&Math.abs(m-p)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+y)<.1&&Math.abs(m+p)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(c+1)/2,M=(d+1)/2,P=(g+1)/2,E=(h+f)/4,_=(u+y)/4,T=(m+p)/4;return A>M&&A>P?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=_/n):M>P?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=E/s,r=T/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=_/r,s=T/r),this.set(n,s,r,e),this}let v=Math.sqrt((p-m)*(p-m)+(u-y)*(u-y)+(f-h)*(f-h));return Math.abs(v)<.001&&(v=1),this.x=(p-m)/v,this.y=(u-y)/v,this.z=(f-h)/v,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this.w=xe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this.w=xe(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ic=class extends Ni{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Kn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new je(0,0,t,e),this.scissorTest=!1,this.viewport=new je(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Qn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Kn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new co(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},di=class extends ic{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},la=class extends Qn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Dn,this.minFilter=Dn,this.wrapR=Ki,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var sc=class extends Qn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Dn,this.minFilter=Dn,this.wrapR=Ki,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ke=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,f,d,m,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,f,d,m,y,p)}set(t,e,n,s,r,o,a,l,c,h,u,f,d,m,y,p){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=f,g[3]=d,g[7]=m,g[11]=y,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Vr.setFromMatrixColumn(t,0).length(),r=1/Vr.setFromMatrixColumn(t,1).length(),o=1/Vr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,d=o*u,m=a*h,y=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=d+m*c,e[5]=f-y*c,e[9]=-a*l,e[2]=y-f*c,e[6]=m+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,d=l*u,m=c*h,y=c*u;e[0]=f+y*a,e[4]=m*a-d,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=d*a-m,e[6]=y+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,d=l*u,m=c*h,y=c*u;e[0]=f-y*a,e[4]=-o*u,e[8]=m+d*a,e[1]=d+m*a,e[5]=o*h,e[9]=y-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,d=o*u,m=a*h,y=a*u;e[0]=l*h,e[4]=m*c-d,e[8]=f*c+y,e[1]=l*u,e[5]=y*c+f,e[9]=d*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,m=a*l,y=a*c;e[0]=l*h,e[4]=y-f*u,e[8]=m*u+d,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=d*u+m,e[10]=f-y*u}else if(t.order==="XZY"){let f=o*l,d=o*c,m=a*l,y=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+y,e[5]=o*h,e[9]=d*u-m,e[2]=m*u-d,e[6]=a*h,e[10]=y*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Kx,t,jx)}lookAt(t,e,n){let s=this.elements;return hi.subVectors(t,e),hi.lengthSq()===0&&(hi.z=1),hi.normalize(),Os.crossVectors(n,hi),Os.lengthSq()===0&&(Math.abs(n.z)===1?hi.x+=1e-4:hi.z+=1e-4,hi.normalize(),Os.crossVectors(n,hi)),Os.normalize(),gl.crossVectors(hi,Os),s[0]=Os.x,s[4]=gl.x,s[8]=hi.x,s[1]=Os.y,s[5]=gl.y,s[9]=hi.y,s[2]=Os.z,s[6]=gl.z,s[10]=hi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],d=n[13],m=n[2],y=n[6],p=n[10],g=n[14],v=n[3],A=n[7],M=n[11],P=n[15],E=s[0],_=s[4],T=s[8],k=s[12],U=s[1],C=s[5],F=s[9],G=s[13],D=s[2],V=s[6],$=s[10],H=s[14],ct=s[3],J=s[7],Q=s[11],rt=s[15];return r[0]=o*E+a*U+l*D+c*ct,r[4]=o*_+a*C+l*V+c*J,r[8]=o*T+a*F+l*$+c*Q,r[12]=o*k+a*G+l*H+c*rt,r[1]=h*E+u*U+f*D+d*ct,r[5]=h*_+u*C+f*V+d*J,r[9]=h*T+u*F+f*$+d*Q,r[13]=h*k+u*G+f*H+d*rt,r[2]=m*E+y*U+p*D+g*ct,r[6]=m*_+y*C+p*V+g*J,r[10]=m*T+y*F+p*$+g*Q,r[14]=m*k+y*G+p*H+g*rt,r[3]=v*E+A*U+M*D+P*ct,r[7]=v*_+A*C+M*V+P*J,r[11]=v*T+A*F+M*$+P*Q,r[15]=v*k+A*G+M*H+P*rt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],d=t[14],m=t[3],y=t[7],p=t[11],g=t[15],v=l*d-c*f,A=a*d-c*u,M=a*f-l*u,P=o*d-c*h,E=o*f-l*h,_=o*u-a*h;return e*(y*v-p*A+g*M)-n*(m*v-p*P+g*E)+s*(m*A-y*P+g*_)-r*(m*M-y*E+p*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],d=t[11],m=t[12],y=t[13],p=t[14],g=t[15],v=e*a-n*o,A=e*l-s*o,M=e*c-r*o,P=n*l-s*a,E=n*c-r*a,_=s*c-r*l,T=h*y-u*m,k=h*p-f*m,U=h*g-d*m,C=u*p-f*y,F=u*g-d*y,G=f*g-d*p,D=v*G-A*F+M*C+P*U-E*k+_*T;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/D;return t[0]=(a*G-l*F+c*C)*V,t[1]=(s*F-n*G-r*C)*V,t[2]=(y*_-p*E+g*P)*V,t[3]=(f*E-u*_-d*P)*V,t[4]=(l*U-o*G-c*k)*V,t[5]=(e*G-s*U+r*k)*V,t[6]=(p*M-m*_-g*A)*V,t[7]=(h*_-f*M+d*A)*V,t[8]=(o*F-a*U+c*T)*V,t[9]=(n*U-e*F-r*T)*V,t[10]=(m*E-y*M+g*v)*V,t[11]=(u*M-h*E-d*v)*V,t[12]=(a*k-o*C-l*T)*V,t[13]=(e*C-n*k+s*T)*V,t[14]=(y*A-m*P-p*v)*V,t[15]=(h*P-u*A+f*v)*V,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,d=r*h,m=r*u,y=o*h,p=o*u,g=a*u,v=l*c,A=l*h,M=l*u,P=n.x,E=n.y,_=n.z;return s[0]=(1-(y+g))*P,s[1]=(d+M)*P,s[2]=(m-A)*P,s[3]=0,s[4]=(d-M)*E,s[5]=(1-(f+g))*E,s[6]=(p+v)*E,s[7]=0,s[8]=(m+A)*_,s[9]=(p-v)*_,s[10]=(1-(f+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Vr.set(s[0],s[1],s[2]).length(),a=Vr.set(s[4],s[5],s[6]).length(),l=Vr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Pi.copy(this);let c=1/o,h=1/a,u=1/l;return Pi.elements[0]*=c,Pi.elements[1]*=c,Pi.elements[2]*=c,Pi.elements[4]*=h,Pi.elements[5]*=h,Pi.elements[6]*=h,Pi.elements[8]*=u,Pi.elements[9]*=u,Pi.elements[10]*=u,e.setFromRotationMatrix(Pi),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Mi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),f=(e+t)/(e-t),d=(n+s)/(n-s),m,y;if(l)m=r/(o-r),y=o*r/(o-r);else if(a===Mi)m=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===oo)m=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Mi,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),f=-(e+t)/(e-t),d=-(n+s)/(n-s),m,y;if(l)m=1/(o-r),y=o/(o-r);else if(a===Mi)m=-2/(o-r),y=-(o+r)/(o-r);else if(a===oo)m=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Vr=new X,Pi=new ke,Kx=new X(0,0,0),jx=new X(1,1,1),Os=new X,gl=new X,hi=new X,xp=new ke,yp=new jn,vs=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(xe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xe(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(xe(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xe(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-xe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return xp.makeRotationFromQuaternion(t),this.setFromRotationMatrix(xp,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return yp.setFromEuler(this),this.setFromQuaternion(yp,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};vs.DEFAULT_ORDER="XYZ";var ca=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Qx=0,vp=new X,Gr=new jn,ds=new ke,_l=new X,$o=new X,ty=new X,ey=new jn,Sp=new X(1,0,0),Mp=new X(0,1,0),bp=new X(0,0,1),wp={type:"added"},ny={type:"removed"},Hr={type:"childadded",child:null},au={type:"childremoved",child:null},Nn=class i extends Ni{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Qx++}),this.uuid=Ks(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new X,e=new vs,n=new jn,s=new X(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ke},normalMatrix:{value:new re}}),this.matrix=new ke,this.matrixWorld=new ke,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ca,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Gr.setFromAxisAngle(t,e),this.quaternion.multiply(Gr),this}rotateOnWorldAxis(t,e){return Gr.setFromAxisAngle(t,e),this.quaternion.premultiply(Gr),this}rotateX(t){return this.rotateOnAxis(Sp,t)}rotateY(t){return this.rotateOnAxis(Mp,t)}rotateZ(t){return this.rotateOnAxis(bp,t)}translateOnAxis(t,e){return vp.copy(t).applyQuaternion(this.quaternion),this.position.add(vp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Sp,t)}translateY(t){return this.translateOnAxis(Mp,t)}translateZ(t){return this.translateOnAxis(bp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ds.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?_l.copy(t):_l.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),$o.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ds.lookAt($o,_l,this.up):ds.lookAt(_l,$o,this.up),this.quaternion.setFromRotationMatrix(ds),s&&(ds.extractRotation(s.matrixWorld),Gr.setFromRotationMatrix(ds),this.quaternion.premultiply(Gr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ie("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(wp),Hr.child=t,this.dispatchEvent(Hr),Hr.child=null):ie("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(ny),au.child=t,this.dispatchEvent(au),au.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ds.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ds.multiply(t.parent.matrixWorld)),t.applyMatrix4(ds),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(wp),Hr.child=t,this.dispatchEvent(Hr),Hr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose($o,t,ty),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose($o,ey,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),d=o(t.animations),m=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new X(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var On=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},iy={type:"move"},ho=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new On,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new On,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new On,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let p=e.getJointPose(y,n),g=this._getHandJoint(c,y);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,m=.005;c.inputState.pinching&&f>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(iy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new On;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},Em={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Bs={h:0,s:0,l:0},xl={h:0,s:0,l:0};function lu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var he=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Zn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Se.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Se.workingColorSpace){return this.r=t,this.g=e,this.b=n,Se.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Se.workingColorSpace){if(t=af(t,1),e=xe(e,0,1),n=xe(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=lu(o,r,t+1/3),this.g=lu(o,r,t),this.b=lu(o,r,t-1/3)}return Se.colorSpaceToWorking(this,s),this}setStyle(t,e=Zn){function n(r){r!==void 0&&parseFloat(r)<1&&jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Zn){let n=Em[t.toLowerCase()];return n!==void 0?this.setHex(n,e):jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=xs(t.r),this.g=xs(t.g),this.b=xs(t.b),this}copyLinearToSRGB(t){return this.r=so(t.r),this.g=so(t.g),this.b=so(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Zn){return Se.workingToColorSpace(Vn.copy(this),t),Math.round(xe(Vn.r*255,0,255))*65536+Math.round(xe(Vn.g*255,0,255))*256+Math.round(xe(Vn.b*255,0,255))}getHexString(t=Zn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Se.workingColorSpace){Se.workingToColorSpace(Vn.copy(this),e);let n=Vn.r,s=Vn.g,r=Vn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Se.workingColorSpace){return Se.workingToColorSpace(Vn.copy(this),e),t.r=Vn.r,t.g=Vn.g,t.b=Vn.b,t}getStyle(t=Zn){Se.workingToColorSpace(Vn.copy(this),t);let e=Vn.r,n=Vn.g,s=Vn.b;return t!==Zn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Bs),this.setHSL(Bs.h+t,Bs.s+e,Bs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Bs),t.getHSL(xl);let n=na(Bs.h,xl.h,e),s=na(Bs.s,xl.s,e),r=na(Bs.l,xl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Vn=new he;he.NAMES=Em;var ha=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new vs,this.environmentIntensity=1,this.environmentRotation=new vs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ii=new X,ps=new X,cu=new X,ms=new X,Wr=new X,Xr=new X,Tp=new X,hu=new X,uu=new X,fu=new X,du=new je,pu=new je,mu=new je,Ji=class i{constructor(t=new X,e=new X,n=new X){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ii.subVectors(t,e),s.cross(Ii);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ii.subVectors(s,e),ps.subVectors(n,e),cu.subVectors(t,e);let o=Ii.dot(Ii),a=Ii.dot(ps),l=Ii.dot(cu),c=ps.dot(ps),h=ps.dot(cu),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-a*h)*f,m=(o*h-a*l)*f;return r.set(1-d-m,m,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,ms)===null?!1:ms.x>=0&&ms.y>=0&&ms.x+ms.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ms.x),l.addScaledVector(o,ms.y),l.addScaledVector(a,ms.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return du.setScalar(0),pu.setScalar(0),mu.setScalar(0),du.fromBufferAttribute(t,e),pu.fromBufferAttribute(t,n),mu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(du,r.x),o.addScaledVector(pu,r.y),o.addScaledVector(mu,r.z),o}static isFrontFacing(t,e,n,s){return Ii.subVectors(n,e),ps.subVectors(t,e),Ii.cross(ps).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ii.subVectors(this.c,this.b),ps.subVectors(this.a,this.b),Ii.cross(ps).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Wr.subVectors(s,n),Xr.subVectors(r,n),hu.subVectors(t,n);let l=Wr.dot(hu),c=Xr.dot(hu);if(l<=0&&c<=0)return e.copy(n);uu.subVectors(t,s);let h=Wr.dot(uu),u=Xr.dot(uu);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(Wr,o);fu.subVectors(t,r);let d=Wr.dot(fu),m=Xr.dot(fu);if(m>=0&&d<=m)return e.copy(r);let y=d*c-l*m;if(y<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(n).addScaledVector(Xr,a);let p=h*m-d*u;if(p<=0&&u-h>=0&&d-m>=0)return Tp.subVectors(r,s),a=(u-h)/(u-h+(d-m)),e.copy(s).addScaledVector(Tp,a);let g=1/(p+y+f);return o=y*g,a=f*g,e.copy(n).addScaledVector(Wr,o).addScaledVector(Xr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Gs=class{constructor(t=new X(1/0,1/0,1/0),e=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Li.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Li.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Li.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Li):Li.fromBufferAttribute(r,o),Li.applyMatrix4(t.matrixWorld),this.expandByPoint(Li);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),yl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),yl.copy(n.boundingBox)),yl.applyMatrix4(t.matrixWorld),this.union(yl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Li),Li.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Yo),vl.subVectors(this.max,Yo),qr.subVectors(t.a,Yo),$r.subVectors(t.b,Yo),Yr.subVectors(t.c,Yo),ks.subVectors($r,qr),zs.subVectors(Yr,$r),or.subVectors(qr,Yr);let e=[0,-ks.z,ks.y,0,-zs.z,zs.y,0,-or.z,or.y,ks.z,0,-ks.x,zs.z,0,-zs.x,or.z,0,-or.x,-ks.y,ks.x,0,-zs.y,zs.x,0,-or.y,or.x,0];return!gu(e,qr,$r,Yr,vl)||(e=[1,0,0,0,1,0,0,0,1],!gu(e,qr,$r,Yr,vl))?!1:(Sl.crossVectors(ks,zs),e=[Sl.x,Sl.y,Sl.z],gu(e,qr,$r,Yr,vl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Li).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Li).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(gs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),gs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),gs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),gs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),gs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),gs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),gs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),gs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(gs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},gs=[new X,new X,new X,new X,new X,new X,new X,new X],Li=new X,yl=new Gs,qr=new X,$r=new X,Yr=new X,ks=new X,zs=new X,or=new X,Yo=new X,vl=new X,Sl=new X,ar=new X;function gu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){ar.fromArray(i,r);let a=s.x*Math.abs(ar.x)+s.y*Math.abs(ar.y)+s.z*Math.abs(ar.z),l=t.dot(ar),c=e.dot(ar),h=n.dot(ar);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var _n=new X,Ml=new Yt,sy=0,Di=class extends Ni{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:sy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=rf,this.updateRanges=[],this.gpuType=Fi,this.version=0,this._normalizationScale=t!==void 0?uh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Ml.fromBufferAttribute(this,e),Ml.applyMatrix3(t),this.setXY(e,Ml.x,Ml.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix3(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix4(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyNormalMatrix(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.transformDirection(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):cf(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):hf(t,this.array)}};var ua=class extends Di{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var fa=class extends Di{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Ce=class extends Di{constructor(t,e,n){super(new Float32Array(t),e,n)}},ry=new Gs,Zo=new X,_u=new X,hr=class{constructor(t=new X,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):ry.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Zo.subVectors(t,this.center);let e=Zo.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Zo,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(_u.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Zo.copy(t.center).add(_u)),this.expandByPoint(Zo.copy(t.center).sub(_u))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},oy=0,Si=new ke,xu=new Nn,Zr=new X,ui=new Gs,Jo=new Gs,Ln=new X,an=class i extends Ni{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:oy++}),this.uuid=Ks(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Ix(t)?fa:ua)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new re().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Si.makeRotationFromQuaternion(t),this.applyMatrix4(Si),this}rotateX(t){return Si.makeRotationX(t),this.applyMatrix4(Si),this}rotateY(t){return Si.makeRotationY(t),this.applyMatrix4(Si),this}rotateZ(t){return Si.makeRotationZ(t),this.applyMatrix4(Si),this}translate(t,e,n){return Si.makeTranslation(t,e,n),this.applyMatrix4(Si),this}scale(t,e,n){return Si.makeScale(t,e,n),this.applyMatrix4(Si),this}lookAt(t){return xu.lookAt(t),xu.updateMatrix(),this.applyMatrix4(xu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Zr).negate(),this.translate(Zr.x,Zr.y,Zr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ce(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Gs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ui.setFromBufferAttribute(r),this.morphTargetsRelative?(Ln.addVectors(this.boundingBox.min,ui.min),this.boundingBox.expandByPoint(Ln),Ln.addVectors(this.boundingBox.max,ui.max),this.boundingBox.expandByPoint(Ln)):(this.boundingBox.expandByPoint(ui.min),this.boundingBox.expandByPoint(ui.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ie('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new hr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(t){let n=this.boundingSphere.center;if(ui.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Jo.setFromBufferAttribute(a),this.morphTargetsRelative?(Ln.addVectors(ui.min,Jo.min),ui.expandByPoint(Ln),Ln.addVectors(ui.max,Jo.max),ui.expandByPoint(Ln)):(ui.expandByPoint(Jo.min),ui.expandByPoint(Jo.max))}ui.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Ln.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Ln));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ln.fromBufferAttribute(a,c),l&&(Zr.fromBufferAttribute(t,c),Ln.add(Zr)),s=Math.max(s,n.distanceToSquared(Ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ie('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ie("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Di(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let k=0;k<n.count;k++)a[k]=new X,l[k]=new X;let h=new X,u=new X,f=new X,d=new Yt,m=new Yt,y=new Yt,p=new X,g=new X;function v(k,U,C){c[k]=c[U]=c[C]=1,h.fromBufferAttribute(n,k),u.fromBufferAttribute(n,U),f.fromBufferAttribute(n,C),d.fromBufferAttribute(r,k),m.fromBufferAttribute(r,U),y.fromBufferAttribute(r,C),u.sub(h),f.sub(h),m.sub(d),y.sub(d);let F=1/(m.x*y.y-y.x*m.y);isFinite(F)&&(p.copy(u).multiplyScalar(y.y).addScaledVector(f,-m.y).multiplyScalar(F),g.copy(f).multiplyScalar(m.x).addScaledVector(u,-y.x).multiplyScalar(F),a[k].add(p),a[U].add(p),a[C].add(p),l[k].add(g),l[U].add(g),l[C].add(g))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let k=0,U=A.length;k<U;++k){let C=A[k],F=C.start,G=C.count;for(let D=F,V=F+G;D<V;D+=3)v(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let M=new X,P=new X,E=new X,_=new X;function T(k){E.fromBufferAttribute(s,k),_.copy(E);let U=a[k];M.copy(U),M.sub(E.multiplyScalar(E.dot(U))).normalize(),P.crossVectors(_,U);let F=P.dot(l[k])<0?-1:1;o.setXYZW(k,M.x,M.y,M.z,F)}for(let k=0,U=n.count;k<U;++k)c[k]&&T(k);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Di(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,h=new X,u=new X;if(t)for(let f=0,d=t.count;f<d;f+=3){let m=t.getX(f+0),y=t.getX(f+1),p=t.getX(f+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Ln.fromBufferAttribute(t,e),Ln.normalize(),t.setXYZ(e,Ln.x,Ln.y,Ln.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),d=0,m=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*h;for(let g=0;g<h;g++)f[m++]=c[d++]}return new Di(f,h,u)}if(this.index===null)return jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},rc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=rf,this.updateRanges=[],this.version=0,this.uuid=Ks()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Ep(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Ep(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Ep(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Ks()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Yn=new X,da=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?uh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)Yn.fromBufferAttribute(this,e),Yn.applyMatrix4(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Yn.fromBufferAttribute(this,e),Yn.applyNormalMatrix(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Yn.fromBufferAttribute(this,e),Yn.transformDirection(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){aa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Di(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){aa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):cf(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):hf(t,this.data.array)}},yu=new X,ay=new X,ly=new re,fi=class{constructor(t=new X(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=yu.subVectors(n,e).cross(ay.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(yu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||ly.getNormalMatrix(t),s=this.coplanarPoint(yu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},cy=0,ji=class extends Ni{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:cy++}),this.uuid=Ks(),this.name="",this.type="Material",this.blending=xo,this.side=Zs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ou,this.blendDst=Bu,this.blendEquation=dr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=ro,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=gm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Xl,this.stencilZFail=Xl,this.stencilZPass=Xl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new he().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new fi().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Yt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},uo=class extends ji{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new he(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Jr,Ko=new X,Kr=new X,jr=new X,Qr=new Yt,jo=new Yt,Am=new ke,bl=new X,Qo=new X,wl=new X,Ap=new Yt,vu=new Yt,Cp=new Yt,pa=class extends Nn{constructor(t=new uo){if(super(),this.isSprite=!0,this.type="Sprite",Jr===void 0){Jr=new an;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new rc(e,5);Jr.setIndex([0,1,2,0,2,3]),Jr.setAttribute("position",new da(n,3,0,!1)),Jr.setAttribute("uv",new da(n,2,3,!1))}this.geometry=Jr,this.material=t,this.center=new Yt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ie('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Kr.setFromMatrixScale(this.matrixWorld),Am.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),jr.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Kr.multiplyScalar(-jr.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Tl(bl.set(-.5,-.5,0),jr,o,Kr,s,r),Tl(Qo.set(.5,-.5,0),jr,o,Kr,s,r),Tl(wl.set(.5,.5,0),jr,o,Kr,s,r),Ap.set(0,0),vu.set(1,0),Cp.set(1,1);let a=t.ray.intersectTriangle(bl,Qo,wl,!1,Ko);if(a===null&&(Tl(Qo.set(-.5,.5,0),jr,o,Kr,s,r),vu.set(0,1),a=t.ray.intersectTriangle(bl,wl,Qo,!1,Ko),a===null))return;let l=t.ray.origin.distanceTo(Ko);l<t.near||l>t.far||e.push({distance:l,point:Ko.clone(),uv:Ji.getInterpolation(Ko,bl,Qo,wl,Ap,vu,Cp,new Yt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Tl(i,t,e,n,s,r){Qr.subVectors(i,e).addScalar(.5).multiply(n),s!==void 0?(jo.x=r*Qr.x-s*Qr.y,jo.y=s*Qr.x+r*Qr.y):jo.copy(Qr),i.copy(t),i.x+=jo.x,i.y+=jo.y,i.applyMatrix4(Am)}var _s=new X,Su=new X,El=new X,Al=new X,ur=class{constructor(t=new X,e=new X(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,_s)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=_s.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(_s.copy(this.origin).addScaledVector(this.direction,e),_s.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Su.copy(t).add(e).multiplyScalar(.5),El.copy(e).sub(t).normalize(),Al.copy(this.origin).sub(Su);let r=t.distanceTo(e)*.5,o=-this.direction.dot(El),a=Al.dot(this.direction),l=-Al.dot(El),c=Al.lengthSq(),h=Math.abs(1-o*o),u,f,d,m;if(h>0)if(u=o*l-a,f=o*a-l,m=r*h,u>=0)if(f>=-m)if(f<=m){let y=1/h;u*=y,f*=y,d=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f<=-m?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=m?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Su).addScaledVector(El,f),d}intersectSphere(t,e){if(t.radius<0)return null;_s.subVectors(t.center,this.origin);let n=_s.dot(this.direction),s=_s.dot(_s)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,_s)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,f=t.y-o.y,d=t.z-o.z,m=e.x-o.x,y=e.y-o.y,p=e.z-o.z,g=n.x-o.x,v=n.y-o.y,A=n.z-o.z,M=Math.abs(l),P=Math.abs(c),E=Math.abs(h),_,T,k,U,C,F,G,D,V,$,H,ct;if(M>=P&&M>=E?(k=l,F=u,V=m,ct=g,l>=0?(_=c,T=h,U=f,C=d,G=y,D=p,$=v,H=A):(_=h,T=c,U=d,C=f,G=p,D=y,$=A,H=v)):P>=E?(k=c,F=f,V=y,ct=v,c>=0?(_=h,T=l,U=d,C=u,G=p,D=m,$=A,H=g):(_=l,T=h,U=u,C=d,G=m,D=p,$=g,H=A)):(k=h,F=d,V=p,ct=A,h>=0?(_=l,T=c,U=u,C=f,G=m,D=y,$=g,H=v):(_=c,T=l,U=f,C=u,G=y,D=m,$=v,H=g)),k===0)return null;let J=_/k,Q=T/k,rt=1/k,dt=U-J*F,ft=C-Q*F,et=G-J*V,_t=D-Q*V,vt=$-J*ct,Rt=H-Q*ct,wt=vt*_t-Rt*et,qt=dt*Rt-ft*vt,le=et*ft-_t*dt;if(s){if(wt<0||qt<0||le<0)return null}else if((wt<0||qt<0||le<0)&&(wt>0||qt>0||le>0))return null;let Wt=wt+qt+le;if(Wt===0)return null;let me=rt*(wt*F+qt*V+le*ct);return(Wt>0?me<0:me>0)?null:this.at(me/Wt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ss=class extends ji{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vs,this.combine=ku,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Rp=new ke,lr=new ur,Cl=new hr,Pp=new X,Rl=new X,Pl=new X,Il=new X,Mu=new X,Ll=new X,Ip=new X,Dl=new X,Un=class extends Nn{constructor(t=new an,e=new Ss){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ll.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Mu.fromBufferAttribute(u,t),o?Ll.addScaledVector(Mu,h):Ll.addScaledVector(Mu.sub(e),h))}e.add(Ll)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Cl.copy(n.boundingSphere),Cl.applyMatrix4(r),lr.copy(t.ray).recast(t.near),!(Cl.containsPoint(lr.origin)===!1&&(lr.intersectSphere(Cl,Pp)===null||lr.origin.distanceToSquared(Pp)>(t.far-t.near)**2))&&(Rp.copy(r).invert(),lr.copy(t.ray).applyMatrix4(Rp),!(n.boundingBox!==null&&lr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,lr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let p=f[m],g=o[p.materialIndex],v=Math.max(p.start,d.start),A=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let M=v,P=A;M<P;M+=3){let E=a.getX(M),_=a.getX(M+1),T=a.getX(M+2);s=Nl(this,g,t,n,c,h,u,E,_,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let p=m,g=y;p<g;p+=3){let v=a.getX(p),A=a.getX(p+1),M=a.getX(p+2);s=Nl(this,o,t,n,c,h,u,v,A,M),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let p=f[m],g=o[p.materialIndex],v=Math.max(p.start,d.start),A=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let M=v,P=A;M<P;M+=3){let E=M,_=M+1,T=M+2;s=Nl(this,g,t,n,c,h,u,E,_,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let p=m,g=y;p<g;p+=3){let v=p,A=p+1,M=p+2;s=Nl(this,o,t,n,c,h,u,v,A,M),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function hy(i,t,e,n,s,r,o,a){let l;if(t.side===ti?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===Zs,a),l===null)return null;Dl.copy(a),Dl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Dl);return c<e.near||c>e.far?null:{distance:c,point:Dl.clone(),object:i}}function Nl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Rl),i.getVertexPosition(l,Pl),i.getVertexPosition(c,Il);let h=hy(i,t,e,n,Rl,Pl,Il,Ip);if(h){let u=new X;Ji.getBarycoord(Ip,Rl,Pl,Il,u),s&&(h.uv=Ji.getInterpolatedAttribute(s,a,l,c,u,new Yt)),r&&(h.uv1=Ji.getInterpolatedAttribute(r,a,l,c,u,new Yt)),o&&(h.normal=Ji.getInterpolatedAttribute(o,a,l,c,u,new X),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new X,materialIndex:0};Ji.getNormal(Rl,Pl,Il,f.normal),h.face=f,h.barycoord=u}return h}var oc=class extends Qn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Dn,h=Dn,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var cr=new hr,uy=new Yt(.5,.5),Ul=new X,Hs=class{constructor(t=new fi,e=new fi,n=new fi,s=new fi,r=new fi,o=new fi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Mi,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],m=r[8],y=r[9],p=r[10],g=r[11],v=r[12],A=r[13],M=r[14],P=r[15];if(s[0].setComponents(c-o,d-h,g-m,P-v).normalize(),s[1].setComponents(c+o,d+h,g+m,P+v).normalize(),s[2].setComponents(c+a,d+u,g+y,P+A).normalize(),s[3].setComponents(c-a,d-u,g-y,P-A).normalize(),n)s[4].setComponents(l,f,p,M).normalize(),s[5].setComponents(c-l,d-f,g-p,P-M).normalize();else if(s[4].setComponents(c-l,d-f,g-p,P-M).normalize(),e===Mi)s[5].setComponents(c+l,d+f,g+p,P+M).normalize();else if(e===oo)s[5].setComponents(l,f,p,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),cr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),cr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(cr)}intersectsSprite(t){cr.center.set(0,0,0);let e=uy.distanceTo(t.center);return cr.radius=.7071067811865476+e,cr.applyMatrix4(t.matrixWorld),this.intersectsSphere(cr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Ul.x=s.normal.x>0?t.max.x:t.min.x,Ul.y=s.normal.y>0?t.max.y:t.min.y,Ul.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ul)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Lp=new ke,ac=class i{constructor(){this.coordinateSystem=Mi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Lp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Hs),n[s].setFromProjectionMatrix(Lp,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Hs),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var bi=class extends ji{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},lc=new X,cc=new X,Dp=new ke,ta=new ur,Fl=new hr,bu=new X,Np=new X,fo=class extends Nn{constructor(t=new an,e=new bi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)lc.fromBufferAttribute(e,s-1),cc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=lc.distanceTo(cc);t.setAttribute("lineDistance",new Ce(n,1))}else jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Fl.copy(n.boundingSphere),Fl.applyMatrix4(s),Fl.radius+=r,t.ray.intersectsSphere(Fl)===!1)return;Dp.copy(s).invert(),ta.copy(t.ray).applyMatrix4(Dp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let d=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let y=d,p=m-1;y<p;y+=c){let g=h.getX(y),v=h.getX(y+1),A=Ol(this,t,ta,l,g,v,y);A&&e.push(A)}if(this.isLineLoop){let y=h.getX(m-1),p=h.getX(d),g=Ol(this,t,ta,l,y,p,m-1);g&&e.push(g)}}else{let d=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let y=d,p=m-1;y<p;y+=c){let g=Ol(this,t,ta,l,y,y+1,y);g&&e.push(g)}if(this.isLineLoop){let y=Ol(this,t,ta,l,m-1,d,m-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ol(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(lc.fromBufferAttribute(a,s),cc.fromBufferAttribute(a,r),e.distanceSqToSegment(lc,cc,bu,Np)>n)return;bu.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(bu);if(!(c<t.near||c>t.far))return{distance:c,point:Np.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Up=new X,Fp=new X,Qi=class extends fo{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Up.fromBufferAttribute(e,s),Fp.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Up.distanceTo(Fp);t.setAttribute("lineDistance",new Ce(n,1))}else jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ma=class extends Qn{constructor(t=[],e=pr,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},ga=class extends Qn{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ms=class extends Qn{constructor(t,e,n=Ui,s,r,o,a=Dn,l=Dn,c,h=ys,u=1){if(h!==ys&&h!==Ts)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new co(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},_a=class extends Ms{constructor(t,e=Ui,n=pr,s,r,o=Dn,a=Dn,l,c=ys){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},xa=class extends Qn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},pi=class i extends an{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,d=0;m("z","y","x",-1,-1,n,e,t,o,r,0),m("z","y","x",1,-1,n,e,-t,o,r,1),m("x","z","y",1,1,t,n,e,s,o,2),m("x","z","y",1,-1,t,n,-e,s,o,3),m("x","y","z",1,-1,t,e,n,s,r,4),m("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ce(c,3)),this.setAttribute("normal",new Ce(h,3)),this.setAttribute("uv",new Ce(u,2));function m(y,p,g,v,A,M,P,E,_,T,k){let U=M/_,C=P/T,F=M/2,G=P/2,D=E/2,V=_+1,$=T+1,H=0,ct=0,J=new X;for(let Q=0;Q<$;Q++){let rt=Q*C-G;for(let dt=0;dt<V;dt++){let ft=dt*U-F;J[y]=ft*v,J[p]=rt*A,J[g]=D,c.push(J.x,J.y,J.z),J[y]=0,J[p]=0,J[g]=E>0?1:-1,h.push(J.x,J.y,J.z),u.push(dt/_),u.push(1-Q/T),H+=1}}for(let Q=0;Q<T;Q++)for(let rt=0;rt<_;rt++){let dt=f+rt+V*Q,ft=f+rt+V*(Q+1),et=f+(rt+1)+V*(Q+1),_t=f+(rt+1)+V*Q;l.push(dt,ft,_t),l.push(ft,et,_t),ct+=6}a.addGroup(d,ct,k),d+=ct,f+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var bs=class i extends an{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],d=[],m=0,y=[],p=n/2,g=0;v(),o===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new Ce(u,3)),this.setAttribute("normal",new Ce(f,3)),this.setAttribute("uv",new Ce(d,2));function v(){let M=new X,P=new X,E=0,_=(e-t)/n;for(let T=0;T<=r;T++){let k=[],U=T/r,C=U*(e-t)+t;for(let F=0;F<=s;F++){let G=F/s,D=G*l+a,V=Math.sin(D),$=Math.cos(D);P.x=C*V,P.y=-U*n+p,P.z=C*$,u.push(P.x,P.y,P.z),M.set(V,_,$).normalize(),f.push(M.x,M.y,M.z),d.push(G,1-U),k.push(m++)}y.push(k)}for(let T=0;T<s;T++)for(let k=0;k<r;k++){let U=y[k][T],C=y[k+1][T],F=y[k+1][T+1],G=y[k][T+1];(t>0||k!==0)&&(h.push(U,C,G),E+=3),(e>0||k!==r-1)&&(h.push(C,F,G),E+=3)}c.addGroup(g,E,0),g+=E}function A(M){let P=m,E=new Yt,_=new X,T=0,k=M===!0?t:e,U=M===!0?1:-1;for(let F=1;F<=s;F++)u.push(0,p*U,0),f.push(0,U,0),d.push(.5,.5),m++;let C=m;for(let F=0;F<=s;F++){let D=F/s*l+a,V=Math.cos(D),$=Math.sin(D);_.x=k*$,_.y=p*U,_.z=k*V,u.push(_.x,_.y,_.z),f.push(0,U,0),E.x=V*.5+.5,E.y=$*.5*U+.5,d.push(E.x,E.y),m++}for(let F=0;F<s;F++){let G=P+F,D=C+F;M===!0?h.push(D,D+1,G):h.push(D+1,D,G),T+=3}c.addGroup(g,T,M===!0?1:2),g+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Bl=new X,kl=new X,wu=new X,zl=new Ji,ya=class extends an{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(io*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),f=new Map,d=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:y,b:p,c:g}=zl;if(y.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),zl.getNormal(wu),u[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,u[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let A=(v+1)%3,M=u[v],P=u[A],E=zl[h[v]],_=zl[h[A]],T=`${M}_${P}`,k=`${P}_${M}`,U=f.get(k);U?(wu.dot(U.normal)<=r&&(d.push(E.x,E.y,E.z),d.push(_.x,_.y,_.z)),f.set(k,null)):f.has(T)||f.set(T,{index0:c[v],index1:c[A],normal:wu.clone()})}}for(let m of f.values())if(m){let{index0:y,index1:p}=m;Bl.fromBufferAttribute(a,y),kl.fromBufferAttribute(a,p),d.push(Bl.x,Bl.y,Bl.z),d.push(kl.x,kl.y,kl.z)}this.setAttribute("position",new Ce(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var va=class i extends an{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,d=[],m=[],y=[],p=[];for(let g=0;g<h;g++){let v=g*f-o;for(let A=0;A<c;A++){let M=A*u-r;m.push(M,-v,0),y.push(0,0,1),p.push(A/a),p.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let A=v+c*g,M=v+c*(g+1),P=v+1+c*(g+1),E=v+1+c*g;d.push(A,M,E),d.push(M,P,E)}this.setIndex(d),this.setAttribute("position",new Ce(m,3)),this.setAttribute("normal",new Ce(y,3)),this.setAttribute("uv",new Ce(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}},Sa=class i extends an{constructor(t=.5,e=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=t,f=(e-t)/s,d=new X,m=new Yt;for(let y=0;y<=s;y++){for(let p=0;p<=n;p++){let g=r+p/n*o;d.x=u*Math.cos(g),d.y=u*Math.sin(g),l.push(d.x,d.y,d.z),c.push(0,0,1),m.x=(d.x/e+1)/2,m.y=(d.y/e+1)/2,h.push(m.x,m.y)}u+=f}for(let y=0;y<s;y++){let p=y*(n+1);for(let g=0;g<n;g++){let v=g+p,A=v,M=v+n+1,P=v+n+2,E=v+1;a.push(A,M,E),a.push(M,P,E)}}this.setIndex(a),this.setAttribute("position",new Ce(l,3)),this.setAttribute("normal",new Ce(c,3)),this.setAttribute("uv",new Ce(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}};var Ma=class i extends an{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new X,f=new X,d=[],m=[],y=[],p=[];for(let g=0;g<=n;g++){let v=[],A=g/n,M=o+A*a,P=t*Math.cos(M),E=Math.sqrt(t*t-P*P),_=0;g===0&&o===0?_=.5/e:g===n&&l===Math.PI&&(_=-.5/e);for(let T=0;T<=e;T++){let k=T/e,U=s+k*r;u.x=-E*Math.cos(U),u.y=P,u.z=E*Math.sin(U),m.push(u.x,u.y,u.z),f.copy(u).normalize(),y.push(f.x,f.y,f.z),p.push(k+_,1-A),v.push(c++)}h.push(v)}for(let g=0;g<n;g++)for(let v=0;v<e;v++){let A=h[g][v+1],M=h[g][v],P=h[g+1][v],E=h[g+1][v+1];(g!==0||o>0)&&d.push(A,M,E),(g!==n-1||l<Math.PI)&&d.push(M,P,E)}this.setIndex(d),this.setAttribute("position",new Ce(m,3)),this.setAttribute("normal",new Ce(y,3)),this.setAttribute("uv",new Ce(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function gr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Op(s))s.isRenderTargetTexture?(jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Op(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Gn(i){let t={};for(let e=0;e<i.length;e++){let n=gr(i[e]);for(let s in n)t[s]=n[s]}return t}function Op(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function fy(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function ff(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Se.workingColorSpace}var Cm={clone:gr,merge:Gn},dy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,py=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ts=class extends ji{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=dy,this.fragmentShader=py,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=gr(t.uniforms),this.uniformsGroups=fy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new he().setHex(s.value);break;case"v2":this.uniforms[n].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new X().fromArray(s.value);break;case"v4":this.uniforms[n].value=new je().fromArray(s.value);break;case"m3":this.uniforms[n].value=new re().fromArray(s.value);break;case"m4":this.uniforms[n].value=new ke().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},hc=class extends ts{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},es=class extends ji{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new he(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=hh,this.normalScale=new Yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vs,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var uc=class extends ji{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=pm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},fc=class extends ji{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};var ba=class extends bi{constructor(t){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}};function to(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Vl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Ws=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},dc=class extends Ws{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Au,endingEnd:Au}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Cu:r=t,a=2*e-n;break;case Ru:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Cu:o=t,l=2*n-e;break;case Ru:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,m=(n-e)/(s-e),y=m*m,p=y*m,g=-f*p+2*f*y-f*m,v=(1+f)*p+(-1.5-2*f)*y+(-.5+f)*m+1,A=(-1-d)*p+(1.5+d)*y+.5*m,M=d*p-d*y;for(let P=0;P!==a;++P)r[P]=g*o[h+P]+v*o[c+P]+A*o[l+P]+M*o[u+P];return r}},pc=class extends Ws{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},mc=class extends Ws{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},gc=class extends Ws{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let m=(n-e)/(s-e),y=1-m;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*m;return r}let f=a*2,d=t-1;for(let m=0;m!==a;++m){let y=o[c+m],p=o[l+m],g=d*f+m*2,v=u[g],A=u[g+1],M=t*f+m*2,P=h[M],E=h[M+1],_=gy(n,e,v,P,s);r[m]=Rm(_,y,A,E,p)}return r}};function Rm(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function my(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function gy(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=Rm(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=my(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var mi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=to(e,this.TimeBufferType),this.values=to(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:to(t.times,Array),values:to(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Vl(t.settings)&&(n.settings={inTangents:to(t.settings.inTangents,Array),outTangents:to(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new mc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new pc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new dc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new gc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ia:e=this.InterpolantFactoryMethodDiscrete;break;case ec:e=this.InterpolantFactoryMethodLinear;break;case Wl:e=this.InterpolantFactoryMethodSmooth;break;case Eu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return jt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ia;case this.InterpolantFactoryMethodLinear:return ec;case this.InterpolantFactoryMethodSmooth:return Wl;case this.InterpolantFactoryMethodBezier:return Eu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Vl(this.settings)&&(Bp(this.settings.inTangents,t),Bp(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Vl(this.settings)&&(kp(this.settings.inTangents,t),kp(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ie("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ie("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ie("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ie("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Lx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ie("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Wl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,f=u-n,d=u+n;for(let m=0;m!==n;++m){let y=e[u+m];if(y!==e[f+m]||y!==e[d+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[u+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Vl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Bp(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function kp(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}mi.prototype.ValueTypeName="";mi.prototype.TimeBufferType=Float32Array;mi.prototype.ValueBufferType=Float32Array;mi.prototype.DefaultInterpolation=ec;var Xs=class extends mi{constructor(t,e,n){super(t,e,n)}};Xs.prototype.ValueTypeName="bool";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=ia;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var _c=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}};_c.prototype.ValueTypeName="color";var xc=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}};xc.prototype.ValueTypeName="number";var yc=class extends Ws{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)jn.slerpFlat(r,0,o,c-a,o,c,l);return r}},wa=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new yc(this.times,this.values,this.getValueSize(),t)}};wa.prototype.ValueTypeName="quaternion";wa.prototype.InterpolantFactoryMethodSmooth=void 0;var qs=class extends mi{constructor(t,e,n){super(t,e,n)}};qs.prototype.ValueTypeName="string";qs.prototype.ValueBufferType=Array;qs.prototype.DefaultInterpolation=ia;qs.prototype.InterpolantFactoryMethodLinear=void 0;qs.prototype.InterpolantFactoryMethodSmooth=void 0;var vc=class extends mi{constructor(t,e,n,s){super(t,e,n,s)}};vc.prototype.ValueTypeName="vector";var Sc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],m=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Pm=new Sc,Mc=class{constructor(t){this.manager=t!==void 0?t:Pm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Mc.DEFAULT_MATERIAL_NAME="__DEFAULT";var po=class extends Nn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new he(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ta=class extends po{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new he(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Tu=new ke,zp=new X,Vp=new X,bc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Yt(512,512),this.mapType=si,this.map=null,this.mapPass=null,this.matrix=new ke,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Hs,this._frameExtents=new Yt(1,1),this._viewportCount=1,this._viewports=[new je(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;zp.setFromMatrixPosition(t.matrixWorld),e.position.copy(zp),Vp.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Vp),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Tu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Tu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===oo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Tu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Gl=new X,Hl=new jn,Zi=new X,Ea=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ke,this.projectionMatrix=new ke,this.projectionMatrixInverse=new ke,this.coordinateSystem=Mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Gl,Hl,Zi),Zi.x===1&&Zi.y===1&&Zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Gl,Hl,Zi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Gl,Hl,Zi),Zi.x===1&&Zi.y===1&&Zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Gl,Hl,Zi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Vs=new X,Gp=new Yt,Hp=new Yt,Jn=class extends Ea{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=lo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(io*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return lo*2*Math.atan(Math.tan(io*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Vs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Vs.x,Vs.y).multiplyScalar(-t/Vs.z),Vs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Vs.x,Vs.y).multiplyScalar(-t/Vs.z)}getViewSize(t,e){return this.getViewBounds(t,Gp,Hp),e.subVectors(Hp,Gp)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(io*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Aa=class extends Ea{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Pu=class extends bc{constructor(){super(new Aa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ca=class extends po{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new Pu}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Ra=class extends po{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var eo=-90,no=1,mo=class extends Nn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Jn(eo,no,t,e);s.layers=this.layers,this.add(s);let r=new Jn(eo,no,t,e);r.layers=this.layers,this.add(r);let o=new Jn(eo,no,t,e);o.layers=this.layers,this.add(o);let a=new Jn(eo,no,t,e);a.layers=this.layers,this.add(a);let l=new Jn(eo,no,t,e);l.layers=this.layers,this.add(l);let c=new Jn(eo,no,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Mi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===oo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,f,d),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},wc=class extends Jn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var df="\\[\\]\\.:\\/",_y=new RegExp("["+df+"]","g"),pf="[^"+df+"]",xy="[^"+df.replace("\\.","")+"]",yy=/((?:WC+[\/:])*)/.source.replace("WC",pf),vy=/(WCOD+)?/.source.replace("WCOD",xy),Sy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",pf),My=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",pf),by=new RegExp("^"+yy+vy+Sy+My+"$"),wy=["material","materials","bones","map"],Iu=class{constructor(t,e,n){let s=n||Ye.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ye=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(_y,"")}static parseTrackName(t){let e=by.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);wy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ie("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ie("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ie("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){ie("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){ie("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ie("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ye.Composite=Iu;Ye.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ye.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ye.prototype.GetterByBindingType=[Ye.prototype._getValue_direct,Ye.prototype._getValue_array,Ye.prototype._getValue_arrayElement,Ye.prototype._getValue_toArray];Ye.prototype.SetterByBindingTypeAndVersioning=[[Ye.prototype._setValue_direct,Ye.prototype._setValue_direct_setNeedsUpdate,Ye.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_array,Ye.prototype._setValue_array_setNeedsUpdate,Ye.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_arrayElement,Ye.prototype._setValue_arrayElement_setNeedsUpdate,Ye.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_fromArray,Ye.prototype._setValue_fromArray_setNeedsUpdate,Ye.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var vC=new Float32Array(1);var go=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=xe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(xe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Lu=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Pa=class extends Qi{constructor(t=10,e=10,n=4473924,s=8947848){n=new he(n),s=new he(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,d=0,m=-a;f<=e;f++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let y=f===r?n:s;y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3}let h=new an;h.setAttribute("position",new Ce(l,3)),h.setAttribute("color",new Ce(c,3));let u=new bi({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Ia=class extends Ni{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function mf(i,t,e,n){let s=Ty(n);switch(e){case ju:return i*t;case tf:return i*t/s.components*s.byteLength;case Ic:return i*t/s.components*s.byteLength;case Js:return i*t*2/s.components*s.byteLength;case Lc:return i*t*2/s.components*s.byteLength;case Qu:return i*t*3/s.components*s.byteLength;case Bi:return i*t*4/s.components*s.byteLength;case Dc:return i*t*4/s.components*s.byteLength;case Na:case Ua:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Fa:case Oa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Uc:case Oc:return Math.max(i,16)*Math.max(t,8)/4;case Nc:case Fc:return Math.max(i,8)*Math.max(t,8)/2;case Bc:case kc:case Vc:case Gc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case zc:case Ba:case Hc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Wc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Xc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case qc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case $c:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Yc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Zc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Jc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Kc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case jc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Qc:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case th:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case eh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case nh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case ih:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case sh:case rh:case oh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case ah:case lh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case ka:case ch:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Ty(i){switch(i){case si:case Yu:return{byteLength:1,components:1};case vo:case Zu:case Oi:return{byteLength:2,components:1};case Rc:case Pc:return{byteLength:2,components:4};case Ui:case Cc:case Fi:return{byteLength:4,components:1};case Ju:case Ku:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function jm(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Ay(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((d,m)=>d.start-m.start);let f=0;for(let d=1;d<u.length;d++){let m=u[f],y=u[d];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++f,u[f]=y)}u.length=f+1;for(let d=0,m=u.length;d<m;d++){let y=u[d];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Cy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Ry=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Py=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Iy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ly=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Dy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Ny=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Uy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Fy=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Oy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,By=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ky=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,zy=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Vy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Gy=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Hy=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Wy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Xy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,qy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,$y=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Yy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Zy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Jy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Ky=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,jy=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Qy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,tv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ev=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,nv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,iv="gl_FragColor = linearToOutputTexel( gl_FragColor );",sv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,rv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,ov=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,av=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,lv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,cv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,hv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,uv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,fv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,dv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,pv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,mv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,gv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,_v=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,xv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,yv=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,vv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Sv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Mv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,bv=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,wv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Tv=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Ev=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Av=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Cv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Rv=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Pv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Iv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Lv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Dv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Nv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Uv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Fv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Ov=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Bv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,kv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,zv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Vv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Gv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Hv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Wv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Xv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,qv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,$v=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Yv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Zv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Jv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Kv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,jv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Qv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,tS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,eS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,nS=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,iS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,sS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,rS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,oS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,aS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,lS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,cS=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,hS=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,uS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,fS=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,dS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,pS=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,mS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,gS=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,_S=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,xS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,yS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,vS=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,SS=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,MS=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,bS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,wS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,TS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,ES=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,AS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,CS=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,RS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,PS=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,IS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,LS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,DS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,NS=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,US=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,FS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,OS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,BS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,zS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,VS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,GS=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,HS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,WS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,qS=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$S=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,YS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,ZS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,JS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,KS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,jS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,QS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,tM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,eM=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,nM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,iM=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,sM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,rM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,oM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,pe={alphahash_fragment:Cy,alphahash_pars_fragment:Ry,alphamap_fragment:Py,alphamap_pars_fragment:Iy,alphatest_fragment:Ly,alphatest_pars_fragment:Dy,aomap_fragment:Ny,aomap_pars_fragment:Uy,batching_pars_vertex:Fy,batching_vertex:Oy,begin_vertex:By,beginnormal_vertex:ky,bsdfs:zy,iridescence_fragment:Vy,bumpmap_pars_fragment:Gy,clipping_planes_fragment:Hy,clipping_planes_pars_fragment:Wy,clipping_planes_pars_vertex:Xy,clipping_planes_vertex:qy,color_fragment:$y,color_pars_fragment:Yy,color_pars_vertex:Zy,color_vertex:Jy,common:Ky,defaultnormal_vertex:jy,displacementmap_pars_vertex:Qy,displacementmap_vertex:tv,emissivemap_fragment:ev,emissivemap_pars_fragment:nv,colorspace_fragment:iv,colorspace_pars_fragment:sv,envmap_fragment:rv,envmap_common_pars_fragment:ov,envmap_pars_fragment:av,envmap_pars_vertex:lv,envmap_physical_pars_fragment:yv,envmap_vertex:cv,fog_vertex:hv,fog_pars_vertex:uv,fog_fragment:fv,fog_pars_fragment:dv,gradientmap_pars_fragment:pv,lightmap_pars_fragment:mv,lights_lambert_fragment:gv,lights_lambert_pars_fragment:_v,lights_pars_begin:xv,lights_toon_fragment:vv,lights_toon_pars_fragment:Sv,lights_phong_fragment:Mv,lights_phong_pars_fragment:bv,lights_physical_fragment:wv,lights_physical_pars_fragment:Tv,lights_fragment_begin:Ev,lights_fragment_maps:Av,lights_fragment_end:Cv,lightprobes_pars_fragment:Rv,logdepthbuf_fragment:Pv,logdepthbuf_pars_fragment:Iv,logdepthbuf_pars_vertex:Lv,logdepthbuf_vertex:Dv,map_fragment:Nv,map_pars_fragment:Uv,map_particle_fragment:Fv,map_particle_pars_fragment:Ov,metalnessmap_fragment:Bv,metalnessmap_pars_fragment:kv,morphinstance_vertex:zv,morphcolor_vertex:Vv,morphnormal_vertex:Gv,morphtarget_pars_vertex:Hv,morphtarget_vertex:Wv,normal_fragment_begin:Xv,normal_fragment_maps:qv,normal_pars_fragment:$v,normal_pars_vertex:Yv,normal_vertex:Zv,normalmap_pars_fragment:Jv,clearcoat_normal_fragment_begin:Kv,clearcoat_normal_fragment_maps:jv,clearcoat_pars_fragment:Qv,iridescence_pars_fragment:tS,opaque_fragment:eS,packing:nS,premultiplied_alpha_fragment:iS,project_vertex:sS,dithering_fragment:rS,dithering_pars_fragment:oS,roughnessmap_fragment:aS,roughnessmap_pars_fragment:lS,shadowmap_pars_fragment:cS,shadowmap_pars_vertex:hS,shadowmap_vertex:uS,shadowmask_pars_fragment:fS,skinbase_vertex:dS,skinning_pars_vertex:pS,skinning_vertex:mS,skinnormal_vertex:gS,specularmap_fragment:_S,specularmap_pars_fragment:xS,tonemapping_fragment:yS,tonemapping_pars_fragment:vS,transmission_fragment:SS,transmission_pars_fragment:MS,uv_pars_fragment:bS,uv_pars_vertex:wS,uv_vertex:TS,worldpos_vertex:ES,background_vert:AS,background_frag:CS,backgroundCube_vert:RS,backgroundCube_frag:PS,cube_vert:IS,cube_frag:LS,depth_vert:DS,depth_frag:NS,distance_vert:US,distance_frag:FS,equirect_vert:OS,equirect_frag:BS,linedashed_vert:kS,linedashed_frag:zS,meshbasic_vert:VS,meshbasic_frag:GS,meshlambert_vert:HS,meshlambert_frag:WS,meshmatcap_vert:XS,meshmatcap_frag:qS,meshnormal_vert:$S,meshnormal_frag:YS,meshphong_vert:ZS,meshphong_frag:JS,meshphysical_vert:KS,meshphysical_frag:jS,meshtoon_vert:QS,meshtoon_frag:tM,points_vert:eM,points_frag:nM,shadow_vert:iM,shadow_frag:sM,sprite_vert:rM,sprite_frag:oM},Nt={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new re}},envmap:{envMap:{value:null},envMapRotation:{value:new re},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new re}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new re}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new re},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new re},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new re},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new re}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new re}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new re}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0},uvTransform:{value:new re}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}}},ss={basic:{uniforms:Gn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.fog]),vertexShader:pe.meshbasic_vert,fragmentShader:pe.meshbasic_frag},lambert:{uniforms:Gn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new he(0)},envMapIntensity:{value:1}}]),vertexShader:pe.meshlambert_vert,fragmentShader:pe.meshlambert_frag},phong:{uniforms:Gn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pe.meshphong_vert,fragmentShader:pe.meshphong_frag},standard:{uniforms:Gn([Nt.common,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.roughnessmap,Nt.metalnessmap,Nt.fog,Nt.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag},toon:{uniforms:Gn([Nt.common,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.gradientmap,Nt.fog,Nt.lights,{emissive:{value:new he(0)}}]),vertexShader:pe.meshtoon_vert,fragmentShader:pe.meshtoon_frag},matcap:{uniforms:Gn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,{matcap:{value:null}}]),vertexShader:pe.meshmatcap_vert,fragmentShader:pe.meshmatcap_frag},points:{uniforms:Gn([Nt.points,Nt.fog]),vertexShader:pe.points_vert,fragmentShader:pe.points_frag},dashed:{uniforms:Gn([Nt.common,Nt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pe.linedashed_vert,fragmentShader:pe.linedashed_frag},depth:{uniforms:Gn([Nt.common,Nt.displacementmap]),vertexShader:pe.depth_vert,fragmentShader:pe.depth_frag},normal:{uniforms:Gn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,{opacity:{value:1}}]),vertexShader:pe.meshnormal_vert,fragmentShader:pe.meshnormal_frag},sprite:{uniforms:Gn([Nt.sprite,Nt.fog]),vertexShader:pe.sprite_vert,fragmentShader:pe.sprite_frag},background:{uniforms:{uvTransform:{value:new re},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pe.background_vert,fragmentShader:pe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new re}},vertexShader:pe.backgroundCube_vert,fragmentShader:pe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pe.cube_vert,fragmentShader:pe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pe.equirect_vert,fragmentShader:pe.equirect_frag},distance:{uniforms:Gn([Nt.common,Nt.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pe.distance_vert,fragmentShader:pe.distance_frag},shadow:{uniforms:Gn([Nt.lights,Nt.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:pe.shadow_vert,fragmentShader:pe.shadow_frag}};ss.physical={uniforms:Gn([ss.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new re},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new re},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new re},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new re},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new re},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new re},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new re},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new re},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new re},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new re},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new re},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new re},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new re}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag};var fh={r:0,b:0,g:0},aM=new ke,Qm=new re;Qm.set(-1,0,0,0,1,0,0,0,1);function lM(i,t,e,n,s,r){let o=new he(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function d(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let M=v.backgroundBlurriness>0;A=t.get(A,M)}return A}function m(v){let A=!1,M=d(v);M===null?p(o,a):M&&M.isColor&&(p(M,1),A=!0);let P=i.xr.getEnvironmentBlendMode();P==="additive"?e.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,A){let M=d(A);M&&M.isCubeTexture?(c===void 0&&(c=new Un(new pi(1,1,1),new ts({name:"BackgroundCubeMaterial",uniforms:gr(ss.backgroundCube.uniforms),vertexShader:ss.backgroundCube.vertexShader,fragmentShader:ss.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(aM.makeRotationFromEuler(A.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Qm),c.material.toneMapped=Se.getTransfer(M.colorSpace)!==Ie,(h!==M||u!==M.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,f=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Un(new va(2,2),new ts({name:"BackgroundMaterial",uniforms:gr(ss.background.uniforms),vertexShader:ss.background.vertexShader,fragmentShader:ss.background.fragmentShader,side:Zs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=Se.getTransfer(M.colorSpace)!==Ie,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,f=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,A){v.getRGB(fh,ff(i)),e.buffers.color.setClear(fh.r,fh.g,fh.b,A,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:m,addToRenderList:y,dispose:g}}function cM(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(C,F,G,D,V){let $=!1,H=u(C,D,G,F);r!==H&&(r=H,c(r.object)),$=d(C,D,G,V),$&&m(C,D,G,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,M(C,F,G,D),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(C){return i.bindVertexArray(C)}function h(C){return i.deleteVertexArray(C)}function u(C,F,G,D){let V=D.wireframe===!0,$=n[F.id];$===void 0&&($={},n[F.id]=$);let H=C.isInstancedMesh===!0?C.id:0,ct=$[H];ct===void 0&&(ct={},$[H]=ct);let J=ct[G.id];J===void 0&&(J={},ct[G.id]=J);let Q=J[V];return Q===void 0&&(Q=f(l()),J[V]=Q),Q}function f(C){let F=[],G=[],D=[];for(let V=0;V<e;V++)F[V]=0,G[V]=0,D[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:G,attributeDivisors:D,object:C,attributes:{},index:null}}function d(C,F,G,D){let V=r.attributes,$=F.attributes,H=0,ct=G.getAttributes();for(let J in ct)if(ct[J].location>=0){let rt=V[J],dt=$[J];if(dt===void 0&&(J==="instanceMatrix"&&C.instanceMatrix&&(dt=C.instanceMatrix),J==="instanceColor"&&C.instanceColor&&(dt=C.instanceColor)),rt===void 0||rt.attribute!==dt||dt&&rt.data!==dt.data)return!0;H++}return r.attributesNum!==H||r.index!==D}function m(C,F,G,D){let V={},$=F.attributes,H=0,ct=G.getAttributes();for(let J in ct)if(ct[J].location>=0){let rt=$[J];rt===void 0&&(J==="instanceMatrix"&&C.instanceMatrix&&(rt=C.instanceMatrix),J==="instanceColor"&&C.instanceColor&&(rt=C.instanceColor));let dt={};dt.attribute=rt,rt&&rt.data&&(dt.data=rt.data),V[J]=dt,H++}r.attributes=V,r.attributesNum=H,r.index=D}function y(){let C=r.newAttributes;for(let F=0,G=C.length;F<G;F++)C[F]=0}function p(C){g(C,0)}function g(C,F){let G=r.newAttributes,D=r.enabledAttributes,V=r.attributeDivisors;G[C]=1,D[C]===0&&(i.enableVertexAttribArray(C),D[C]=1),V[C]!==F&&(i.vertexAttribDivisor(C,F),V[C]=F)}function v(){let C=r.newAttributes,F=r.enabledAttributes;for(let G=0,D=F.length;G<D;G++)F[G]!==C[G]&&(i.disableVertexAttribArray(G),F[G]=0)}function A(C,F,G,D,V,$,H){H===!0?i.vertexAttribIPointer(C,F,G,V,$):i.vertexAttribPointer(C,F,G,D,V,$)}function M(C,F,G,D){y();let V=D.attributes,$=G.getAttributes(),H=F.defaultAttributeValues;for(let ct in $){let J=$[ct];if(J.location>=0){let Q=V[ct];if(Q===void 0&&(ct==="instanceMatrix"&&C.instanceMatrix&&(Q=C.instanceMatrix),ct==="instanceColor"&&C.instanceColor&&(Q=C.instanceColor)),Q!==void 0){let rt=Q.normalized,dt=Q.itemSize,ft=t.get(Q);if(ft===void 0)continue;let et=ft.buffer,_t=ft.type,vt=ft.bytesPerElement,Rt=_t===i.INT||_t===i.UNSIGNED_INT||Q.gpuType===Cc;if(Q.isInterleavedBufferAttribute){let wt=Q.data,qt=wt.isInterleavedBuffer===!0?wt.stride:wt.itemSize,le=Q.offset;if(wt.isInstancedInterleavedBuffer||wt.isInstancedBufferAttribute){for(let Wt=0;Wt<J.locationSize;Wt++)g(J.location+Wt,wt.meshPerAttribute);C.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=wt.meshPerAttribute*wt.count)}else for(let Wt=0;Wt<J.locationSize;Wt++)p(J.location+Wt);i.bindBuffer(i.ARRAY_BUFFER,et);for(let Wt=0;Wt<J.locationSize;Wt++)A(J.location+Wt,dt/J.locationSize,_t,rt,qt*vt,(le+dt/J.locationSize*Wt)*vt,Rt)}else{if(Q.isInstancedBufferAttribute){for(let wt=0;wt<J.locationSize;wt++)g(J.location+wt,Q.meshPerAttribute);C.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let wt=0;wt<J.locationSize;wt++)p(J.location+wt);i.bindBuffer(i.ARRAY_BUFFER,et);for(let wt=0;wt<J.locationSize;wt++)A(J.location+wt,dt/J.locationSize,_t,rt,dt*vt,dt/J.locationSize*wt*vt,Rt)}}else if(H!==void 0){let rt=H[ct];if(rt!==void 0)switch(rt.length){case 2:i.vertexAttrib2fv(J.location,rt);break;case 3:i.vertexAttrib3fv(J.location,rt);break;case 4:i.vertexAttrib4fv(J.location,rt);break;default:i.vertexAttrib1fv(J.location,rt)}}}}v()}function P(){k();for(let C in n){let F=n[C];for(let G in F){let D=F[G];for(let V in D){let $=D[V];for(let H in $)h($[H].object),delete $[H];delete D[V]}}delete n[C]}}function E(C){if(n[C.id]===void 0)return;let F=n[C.id];for(let G in F){let D=F[G];for(let V in D){let $=D[V];for(let H in $)h($[H].object),delete $[H];delete D[V]}}delete n[C.id]}function _(C){for(let F in n){let G=n[F];for(let D in G){let V=G[D];if(V[C.id]===void 0)continue;let $=V[C.id];for(let H in $)h($[H].object),delete $[H];delete V[C.id]}}}function T(C){for(let F in n){let G=n[F],D=C.isInstancedMesh===!0?C.id:0,V=G[D];if(V!==void 0){for(let $ in V){let H=V[$];for(let ct in H)h(H[ct].object),delete H[ct];delete V[$]}delete G[D],Object.keys(G).length===0&&delete n[F]}}}function k(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:U,dispose:P,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:p,disableUnusedAttributes:v}}function hM(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];e.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function uM(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Bi&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===Oi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==si&&_!==Fi&&!T&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(jt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:M,maxSamples:P,samples:E}}function fM(i){let t=this,e=null,n=0,s=!1,r=!1,o=new fi,a=new re,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||n!==0||s;return s=f,n=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,d){let m=u.clippingPlanes,y=u.clipIntersection,p=u.clipShadows,g=i.get(u);if(!s||m===null||m.length===0||r&&!p)r?h(null):c();else{let v=r?0:n,A=v*4,M=g.clippingState||null;l.value=M,M=h(m,f,A,d);for(let P=0;P!==A;++P)M[P]=e[P];g.clippingState=M,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,f,d,m){let y=u!==null?u.length:0,p=null;if(y!==0){if(p=l.value,m!==!0||p===null){let g=d+y*4,v=f.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<g)&&(p=new Float32Array(g));for(let A=0,M=d;A!==y;++A,M+=4)o.copy(u[A]).applyMatrix4(v,a),o.normal.toArray(p,M),p[M+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,p}}var Ga=class extends di{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ma(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new pi(5,5,5),r=new ts({name:"CubemapFromEquirect",uniforms:gr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ti,blending:fr});r.uniforms.tEquirect.value=e;let o=new Un(s,r),a=e.minFilter;return e.minFilter===ws&&(e.minFilter=Kn),new mo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Im=256,dM=3,pM=20,tg=256,eg=16,mM=3,gM=new X,_M=new he,ph=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new mo(1,10,null),this._boxMesh=new Un(new pi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=gM}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,m=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(_M));let p=new mo(n,s,h);return p.position.copy(a),p.update(l,t),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=m,t.background=y,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Nm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Dm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Im,lf(t))}_fromTexture(t,e){t.mapping===pr||t.mapping===yo?this._setSize(t.image.length===0?Im:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Lm(t,!1,!1),n=Math.log2(t)-dM;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Lm(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===pr||t.mapping===yo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Nm()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Dm()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=xM(),this._integrationMaterial=yM());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/eg);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-mM)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(tg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=vM());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Lm(i,t,e){return new Ga(i,{minFilter:ws,generateMipmaps:t,type:Oi,colorSpace:sa,depthBuffer:e})}function Ha(i,t,e){return new ts({name:i,uniforms:t,vertexShader:pe.cube_vert,fragmentShader:e,side:ti,blending:fr,depthTest:!1,depthWrite:!1})}function xM(){return Ha("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${tg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function yM(){return Ha("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:eg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function vM(){return Ha("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${pM}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Dm(){return Ha("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Nm(){return Ha("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function SM(i){let t=new WeakMap,e=new WeakMap,n=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Tc||d===Ec)if(t.has(f)){let m=t.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let y=new Ga(m.height);return y.fromEquirectangularTexture(i,f),t.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,m=d===Tc||d===Ec,y=d===pr||d===yo;if(m||y){let p=e.get(f),g=p!==void 0?p.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return n===null&&(n=new ph(i)),p=m?n.fromEquirectangular(f,p):n.fromCubemap(f,p),p.texture.pmremVersion=f.pmremVersion,e.set(f,p),p.texture;if(p!==void 0)return p.texture;{let v=f.image;return m&&v&&v.height>0||y&&v&&l(v)?(n===null&&(n=new ph(i)),p=m?n.fromEquirectangular(f):n.fromCubemap(f),p.texture.pmremVersion=f.pmremVersion,e.set(f,p),f.addEventListener("dispose",h),p.texture):null}}}return f}function a(f,d){return d===Tc?f.mapping=pr:d===Ec&&(f.mapping=yo),f}function l(f){let d=0,m=6;for(let y=0;y<m;y++)f[y]!==void 0&&d++;return d===m}function c(f){let d=f.target;d.removeEventListener("dispose",c);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function MM(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&ea("WebGLRenderer: "+n+" extension not supported."),s}}}function bM(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let p in m.attributes)t.remove(m.attributes[p]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let y=r.get(m);y&&(t.remove(y),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function h(m){let y=m.attributes;for(let p in y)t.update(y[p],i.ARRAY_BUFFER)}function u(m){let y=m.index,p=m.attributes.position,g=0;if(p===void 0)return;let v=y!==null?y.array.length:p.array.length/3-1,A=p.count>=65535?fa:ua,M=new A(Math.ceil(v/3)*6,1),P=M.array;if(y!==null){let _=y.array;g=y.version;for(let T=0,k=0;T<v;T+=3){let U=_[T+0],C=_[T+1],F=_[T+2];P[k++]=U,P[k++]=C,P[k++]=C,P[k++]=F,P[k++]=F,P[k++]=U}}else{g=p.version;for(let _=0,T=0;_<v;_+=3){let k=_+0,U=_+1,C=_+2;P[T++]=k,P[T++]=U,P[T++]=U,P[T++]=C,P[T++]=C,P[T++]=k}}M.version=g;let E=r.get(m);E&&t.remove(E),r.set(m,M)}function f(m){let y=r.get(m);if(y){let p=m.index;p!==null&&y.version<p.version&&u(m)}else u(m);return r.get(m)}function d(){for(let m in s){let y=s[m].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function wM(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),e.update(f,n,1)}function c(u,f,d){d!==0&&(i.drawElementsInstanced(n,f,r,u*o,d),e.update(f,n,d))}function h(u,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,d);let y=0;for(let p=0;p<d;p++)y+=f[p];e.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function TM(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:ie("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function EM(i,t,e){let n=new WeakMap,s=new je;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let k=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",k)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;d===!0&&(A=1),m===!0&&(A=2),y===!0&&(A=3);let M=a.attributes.position.count*A,P=1;M>t.maxTextureSize&&(P=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let E=new Float32Array(M*P*4*u),_=new la(E,M,P,u);_.type=Fi,_.needsUpdate=!0;let T=A*4;for(let U=0;U<u;U++){let C=p[U],F=g[U],G=v[U],D=M*P*4*U;for(let V=0;V<C.count;V++){let $=V*T;d===!0&&(s.fromBufferAttribute(C,V),E[D+$+0]=s.x,E[D+$+1]=s.y,E[D+$+2]=s.z,E[D+$+3]=0),m===!0&&(s.fromBufferAttribute(F,V),E[D+$+4]=s.x,E[D+$+5]=s.y,E[D+$+6]=s.z,E[D+$+7]=0),y===!0&&(s.fromBufferAttribute(G,V),E[D+$+8]=s.x,E[D+$+9]=s.y,E[D+$+10]=s.z,E[D+$+11]=G.itemSize===4?s.w:1)}}f={count:u,texture:_,size:new Yt(M,P)},n.set(a,f),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function AM(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=t.get(c,u);if(r.get(f)!==h&&(t.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var CM={[zu]:"LINEAR_TONE_MAPPING",[Vu]:"REINHARD_TONE_MAPPING",[Gu]:"CINEON_TONE_MAPPING",[Hu]:"ACES_FILMIC_TONE_MAPPING",[Xu]:"AGX_TONE_MAPPING",[qu]:"NEUTRAL_TONE_MAPPING",[Wu]:"CUSTOM_TONE_MAPPING"};function RM(i,t,e,n,s,r){let o=new di(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new an;h.setAttribute("position",new Ce([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ce([0,2,0,0,2,0],2));let u=new hc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new Un(h,u),d=new Aa(-1,1,1,-1,0,1),m=null,y=null,p=!1,g,v=null,A=[],M=!1;this.setSize=function(P,E){o.setSize(P,E),a!==null&&a.setSize(P,E),l!==null&&l.setSize(P,E);for(let _=0;_<A.length;_++){let T=A[_];T.setSize&&T.setSize(P,E)}},this.setEffects=function(P){A=P,M=A.length>0&&A[0].isRenderPass===!0;let E=o.width,_=o.height;A.length>0&&a===null&&(a=new di(E,_,{type:Oi,depthBuffer:!1,stencilBuffer:!1}),l=new di(E,_,{type:Oi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(k=>k.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ms(E,_),r===!0&&(c.format=Ts,c.type=mr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let k=0;k<A.length;k++){let U=A[k];U.setSize&&U.setSize(E,_),T&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(P,E){if(p||P.toneMapping===ns&&A.length===0)return!1;if(v=E,E!==null){let _=E.width,T=E.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return M===!1&&P.setRenderTarget(o),g=P.toneMapping,P.toneMapping=ns,!0},this.hasRenderPass=function(){return M},this.end=function(P,E){P.toneMapping=g,p=!0;let _=o,T=a;for(let k=0;k<A.length;k++){let U=A[k];U.enabled!==!1&&(U.render(P,T,_,E),U.needsSwap!==!1&&(_=T,T=T===a?l:a))}if(m!==P.outputColorSpace||y!==P.toneMapping){m=P.outputColorSpace,y=P.toneMapping,u.defines={},Se.getTransfer(m)===Ie&&(u.defines.SRGB_TRANSFER="");let k=CM[y];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,P.setRenderTarget(v),P.render(f,d),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var ng=new Qn,ig=new Ms(1,1),sg=new _a(1),rg=new la,og=new sc,ag=new ma,Um=[],Fm=[],Om=new Float32Array(16),Bm=new Float32Array(9),km=new Float32Array(4);function Mo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Um[s];if(r===void 0&&(r=new Float32Array(s),Um[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Mn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function bn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function gh(i,t){let e=Fm[t];e===void 0&&(e=new Int32Array(t),Fm[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function PM(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function IM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2fv(this.addr,t),bn(e,t)}}function LM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Mn(e,t))return;i.uniform3fv(this.addr,t),bn(e,t)}}function DM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4fv(this.addr,t),bn(e,t)}}function NM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;km.set(n),i.uniformMatrix2fv(this.addr,!1,km),bn(e,n)}}function UM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;Bm.set(n),i.uniformMatrix3fv(this.addr,!1,Bm),bn(e,n)}}function FM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,n))return;Om.set(n),i.uniformMatrix4fv(this.addr,!1,Om),bn(e,n)}}function OM(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function BM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2iv(this.addr,t),bn(e,t)}}function kM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;i.uniform3iv(this.addr,t),bn(e,t)}}function zM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4iv(this.addr,t),bn(e,t)}}function VM(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function GM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2uiv(this.addr,t),bn(e,t)}}function HM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;i.uniform3uiv(this.addr,t),bn(e,t)}}function WM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4uiv(this.addr,t),bn(e,t)}}function _h(i){return i.version===0&&(i.compareFunction=sf,i.needsUpdate=!0),i}function XM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=_h(ig):r=ng,e.setTexture2D(t||r,s)}function qM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||og,s)}function $M(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=_h(sg):r=ag,e.setTextureCube(t||r,s)}function YM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||rg,s)}function ZM(i){switch(i){case 5126:return PM;case 35664:return IM;case 35665:return LM;case 35666:return DM;case 35674:return NM;case 35675:return UM;case 35676:return FM;case 5124:case 35670:return OM;case 35667:case 35671:return BM;case 35668:case 35672:return kM;case 35669:case 35673:return zM;case 5125:return VM;case 36294:return GM;case 36295:return HM;case 36296:return WM;case 35678:case 36198:case 36298:case 36306:case 35682:return XM;case 35679:case 36299:case 36307:return qM;case 35680:case 36300:case 36308:case 36293:return $M;case 36289:case 36303:case 36311:case 36292:return YM}}function JM(i,t){i.uniform1fv(this.addr,t)}function KM(i,t){let e=Mo(t,this.size,2);i.uniform2fv(this.addr,e)}function jM(i,t){let e=Mo(t,this.size,3);i.uniform3fv(this.addr,e)}function QM(i,t){let e=Mo(t,this.size,4);i.uniform4fv(this.addr,e)}function tb(i,t){let e=Mo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function eb(i,t){let e=Mo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function nb(i,t){let e=Mo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function ib(i,t){i.uniform1iv(this.addr,t)}function sb(i,t){i.uniform2iv(this.addr,t)}function rb(i,t){i.uniform3iv(this.addr,t)}function ob(i,t){i.uniform4iv(this.addr,t)}function ab(i,t){i.uniform1uiv(this.addr,t)}function lb(i,t){i.uniform2uiv(this.addr,t)}function cb(i,t){i.uniform3uiv(this.addr,t)}function hb(i,t){i.uniform4uiv(this.addr,t)}function ub(i,t,e){let n=this.cache,s=t.length,r=gh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=_h(ig):o=ng;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function fb(i,t,e){let n=this.cache,s=t.length,r=gh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||og,r[o])}function db(i,t,e){let n=this.cache,s=t.length,r=gh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=_h(sg):o=ag;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function pb(i,t,e){let n=this.cache,s=t.length,r=gh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||rg,r[o])}function mb(i){switch(i){case 5126:return JM;case 35664:return KM;case 35665:return jM;case 35666:return QM;case 35674:return tb;case 35675:return eb;case 35676:return nb;case 5124:case 35670:return ib;case 35667:case 35671:return sb;case 35668:case 35672:return rb;case 35669:case 35673:return ob;case 5125:return ab;case 36294:return lb;case 36295:return cb;case 36296:return hb;case 35678:case 36198:case 36298:case 36306:case 35682:return ub;case 35679:case 36299:case 36307:return fb;case 35680:case 36300:case 36308:case 36293:return db;case 36289:case 36303:case 36311:case 36292:return pb}}var xf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=ZM(e.type)}},yf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=mb(e.type)}},vf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},gf=/(\w+)(\])?(\[|\.)?/g;function zm(i,t){i.seq.push(t),i.map[t.id]=t}function gb(i,t,e){let n=i.name,s=n.length;for(gf.lastIndex=0;;){let r=gf.exec(n),o=gf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){zm(e,c===void 0?new xf(a,i,t):new yf(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new vf(a),zm(e,u)),e=u}}}var So=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);gb(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function Vm(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var _b=37297,xb=0;function yb(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Gm=new re;function vb(i){Se._getMatrix(Gm,Se.workingColorSpace,i);let t=`mat3( ${Gm.elements.map(e=>e.toFixed(4))} )`;switch(Se.getTransfer(i)){case ra:return[t,"LinearTransferOETF"];case Ie:return[t,"sRGBTransferOETF"];default:return jt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Hm(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+yb(i.getShaderSource(t),a)}else return r}function Sb(i,t){let e=vb(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Mb={[zu]:"Linear",[Vu]:"Reinhard",[Gu]:"Cineon",[Hu]:"ACESFilmic",[Xu]:"AgX",[qu]:"Neutral",[Wu]:"Custom"};function bb(i,t){let e=Mb[t];return e===void 0?(jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var dh=new X;function wb(){Se.getLuminanceCoefficients(dh);let i=dh.x.toFixed(4),t=dh.y.toFixed(4),e=dh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Tb(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Va).join(`
`)}function Eb(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Ab(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Va(i){return i!==""}function Wm(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Xm(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Cb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Sf(i){return i.replace(Cb,Rb)}function Rb(i,t){let e=pe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Sf(e)}var Pb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function qm(i){return i.replace(Pb,Ib)}function Ib(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function $m(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var Lb={[La]:"SHADOWMAP_TYPE_PCF",[_o]:"SHADOWMAP_TYPE_VSM"};function Db(i){return Lb[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Nb={[yo]:"ENVMAP_MODE_REFRACTION"};function Ub(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Nb[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Fb={[ku]:"ENVMAP_BLENDING_MULTIPLY",[um]:"ENVMAP_BLENDING_MIX",[fm]:"ENVMAP_BLENDING_ADD"};function Ob(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Fb[i.combine]||"ENVMAP_BLENDING_NONE"}function Bb(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Db(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Ub(e),u=Ob(e),f=Tb(e),d=Eb(r),m=s.createProgram(),y,p,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Va).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Va).join(`
`),p.length>0&&(p+=`
`)):(y=[$m(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Va).join(`
`),p=[$m(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ns?"#define TONE_MAPPING":"",e.toneMapping!==ns?pe.tonemapping_pars_fragment:"",e.toneMapping!==ns?bb("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",pe.colorspace_pars_fragment,Sb("linearToOutputTexel",e.outputColorSpace),wb(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Va).join(`
`)),o=Sf(o),o=Wm(o,e),o=Xm(o,e),a=Sf(a),a=Wm(a,e),a=Xm(a,e),o=qm(o),a=qm(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",e.glslVersion===of?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===of?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=g+y+o,A=g+p+a,M=Vm(s,s.VERTEX_SHADER,v),P=Vm(s,s.FRAGMENT_SHADER,A);s.attachShader(m,M),s.attachShader(m,P),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function E(U){if(i.debug.checkShaderErrors){let C=s.getProgramInfoLog(m)||"",F=s.getShaderInfoLog(M)||"",G=s.getShaderInfoLog(P)||"",D=C.trim(),V=F.trim(),$=G.trim(),H=!0,ct=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,M,P);else{let J=Hm(s,M,"vertex"),Q=Hm(s,P,"fragment");ie("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+D+`
`+J+`
`+Q)}else D!==""?jt("WebGLProgram: Program Info Log:",D):(V===""||$==="")&&(ct=!1);ct&&(U.diagnostics={runnable:H,programLog:D,vertexShader:{log:V,prefix:y},fragmentShader:{log:$,prefix:p}})}s.deleteShader(M),s.deleteShader(P),_=new So(s,m),T=Ab(s,m)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let k=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(m,_b)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=xb++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=M,this.fragmentShader=P,this}var kb=0,Mf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new bf(t),e.set(t,n)),n}},bf=class{constructor(t){this.id=kb++,this.code=t,this.usedTimes=0}};function zb(i){return i===Js||i===Ba||i===ka}function Vb(i,t,e,n,s,r){let o=new ca,a=new Mf,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,T,k,U,C,F){let G=U.fog,D=C.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?U.environment:null,$=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,H=t.get(_.envMap||V,$),ct=f[_.type],J=n.precision;_.precision!==null&&(J=n.getMaxPrecision(_.precision),J!==_.precision&&jt("WebGLProgram.getParameters:",_.precision,"not supported, using",J,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,rt=Q!==void 0?Q.length:0,dt=0;D.morphAttributes.position!==void 0&&(dt=1),D.morphAttributes.normal!==void 0&&(dt=2),D.morphAttributes.color!==void 0&&(dt=3);let ft,et,_t,vt;if(ct){let Pt=ss[ct];ft=Pt.vertexShader,et=Pt.fragmentShader}else{ft=_.vertexShader,et=_.fragmentShader;let Pt=a.getVertexShaderStage(_),ue=a.getFragmentShaderStage(_);a.update(_,Pt,ue),_t=Pt.id,vt=ue.id}let Rt=i.getRenderTarget(),wt=i.state.buffers.depth.getReversed(),qt=C.isInstancedMesh===!0,le=C.isBatchedMesh===!0,Wt=!!_.map,me=!!_.matcap,fe=!!H,oe=fe&&H.isPMREMTexture===!0,Je=!!_.aoMap,He=!!_.lightMap,un=!!_.bumpMap&&_.wireframe===!1,Oe=!!_.normalMap,An=!!_.displacementMap,be=!!_.emissiveMap,yn=!!_.metalnessMap,en=!!_.roughnessMap,fn=_.anisotropy>0,B=_.clearcoat>0,It=_.diffuseRoughness>0,Qt=_.dispersion>0,ce=_.retroreflectivity>0,Tt=_.iridescence>0,ze=_.sheen>0,Ht=_.transmission>0,Kt=fn&&!!_.anisotropyMap,I=B&&!!_.clearcoatMap,S=B&&!!_.clearcoatNormalMap,q=B&&!!_.clearcoatRoughnessMap,ut=It&&!!_.diffuseRoughnessMap,at=Tt&&!!_.iridescenceMap,yt=Tt&&!!_.iridescenceThicknessMap,St=ze&&!!_.sheenColorMap,nt=ze&&!!_.sheenRoughnessMap,st=!!_.specularMap,gt=!!_.specularColorMap,O=!!_.specularIntensityMap,ot=Ht&&!!_.transmissionMap,it=Ht&&!!_.thicknessMap,Et=!!_.gradientMap,xt=!!_.alphaMap,bt=_.alphaTest>0,Xt=!!_.alphaHash,ee=!!_.extensions,ht=ns;_.toneMapped&&(Rt===null||Rt.isXRRenderTarget===!0)&&(ht=i.toneMapping);let zt=oe?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,ne={shaderID:ct,shaderType:_.type,shaderName:_.name,vertexShader:ft,fragmentShader:et,defines:_.defines,customVertexShaderID:_t,customFragmentShaderID:vt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:J,batching:le,batchingColor:le&&C._colorsTexture!==null,instancing:qt,instancingColor:qt&&C.instanceColor!==null,instancingMorph:qt&&C.morphTexture!==null,outputColorSpace:Rt===null?i.outputColorSpace:Rt.isXRRenderTarget===!0?Rt.texture.colorSpace:Se.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Wt,matcap:me,envMap:fe,envMapMode:fe&&H.mapping,envMapPMREM:oe,envMapMaxLod:oe?zt.length-1:null,envMapSize:oe?zt[0].width:null,aoMap:Je,lightMap:He,bumpMap:un,normalMap:Oe,displacementMap:An,emissiveMap:be,normalMapObjectSpace:Oe&&_.normalMapType===mm,normalMapTangentSpace:Oe&&_.normalMapType===hh,packedNormalMap:Oe&&_.normalMapType===hh&&zb(_.normalMap.format),metalnessMap:yn,roughnessMap:en,anisotropy:fn,anisotropyMap:Kt,clearcoat:B,clearcoatMap:I,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:It,diffuseRoughnessMap:ut,dispersion:Qt,retroreflection:ce,iridescence:Tt,iridescenceMap:at,iridescenceThicknessMap:yt,sheen:ze,sheenColorMap:St,sheenRoughnessMap:nt,specularMap:st,specularColorMap:gt,specularIntensityMap:O,transmission:Ht,transmissionMap:ot,thicknessMap:it,gradientMap:Et,opaque:_.transparent===!1&&_.blending===xo&&_.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:Xt,combine:_.combine,mapUv:Wt&&d(_.map.channel),aoMapUv:Je&&d(_.aoMap.channel),lightMapUv:He&&d(_.lightMap.channel),bumpMapUv:un&&d(_.bumpMap.channel),normalMapUv:Oe&&d(_.normalMap.channel),displacementMapUv:An&&d(_.displacementMap.channel),emissiveMapUv:be&&d(_.emissiveMap.channel),metalnessMapUv:yn&&d(_.metalnessMap.channel),roughnessMapUv:en&&d(_.roughnessMap.channel),anisotropyMapUv:Kt&&d(_.anisotropyMap.channel),clearcoatMapUv:I&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:yt&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:St&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:nt&&d(_.sheenRoughnessMap.channel),specularMapUv:st&&d(_.specularMap.channel),specularColorMapUv:gt&&d(_.specularColorMap.channel),specularIntensityMapUv:O&&d(_.specularIntensityMap.channel),transmissionMapUv:ot&&d(_.transmissionMap.channel),thicknessMapUv:it&&d(_.thicknessMap.channel),alphaMapUv:xt&&d(_.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Oe||fn),vertexNormals:!!D.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!D.attributes.uv&&(Wt||xt),fog:!!G,useFog:_.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||D.attributes.normal===void 0&&Oe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:wt,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:rt,morphTextureStride:dt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:F.filter(Pt=>Pt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:ht,decodeVideoTexture:Wt&&_.map.isVideoTexture===!0&&Se.getTransfer(_.map.colorSpace)===Ie,decodeVideoTextureEmissive:be&&_.emissiveMap.isVideoTexture===!0&&Se.getTransfer(_.emissiveMap.colorSpace)===Ie,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===ii,flipSided:_.side===ti,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ee&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ee&&_.extensions.multiDraw===!0||le)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ne.vertexUv1s=l.has(1),ne.vertexUv2s=l.has(2),ne.vertexUv3s=l.has(3),l.clear(),ne}function y(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let k in _.defines)T.push(k),T.push(_.defines[k]);return _.isRawShaderMaterial===!1&&(p(T,_),g(T,_),T.push(i.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function p(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function g(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let T=f[_.type],k;if(T){let U=ss[T];k=Cm.clone(U.uniforms)}else k=_.uniforms;return k}function A(_,T){let k=h.get(T);return k!==void 0?++k.usedTimes:(k=new Bb(i,T,_,s),c.push(k),h.set(T,k)),k}function M(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function P(_){a.remove(_)}function E(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:v,acquireProgram:A,releaseProgram:M,releaseShaderCache:P,programs:c,dispose:E}}function Gb(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Hb(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Ym(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Zm(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,m,y,p,g){let v=i[t];return v===void 0?(v={id:f.id,object:f,geometry:d,material:m,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:p,group:g},i[t]=v):(v.id=f.id,v.object=f,v.geometry=d,v.material=m,v.materialVariant=o(f),v.groupOrder=y,v.renderOrder=f.renderOrder,v.z=p,v.group=g),t++,v}function l(f,d,m,y,p,g,v){v.reversedDepth===!0&&(p=-p);let A=a(f,d,m,y,p,g);m.transmission>0?n.push(A):m.transparent===!0?s.push(A):e.push(A)}function c(f,d,m,y,p,g){let v=a(f,d,m,y,p,g);m.transmission>0?n.unshift(v):m.transparent===!0?s.unshift(v):e.unshift(v)}function h(f,d){e.length>1&&e.sort(f||Hb),n.length>1&&n.sort(d||Ym),s.length>1&&s.sort(d||Ym)}function u(){for(let f=t,d=i.length;f<d;f++){let m=i[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Wb(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new Zm,i.set(n,[o])):s>=r.length?(o=new Zm,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function Xb(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new X,color:new he};break;case"SpotLight":e={position:new X,direction:new X,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new X,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new X,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new X,halfWidth:new X,halfHeight:new X};break}return i[t.id]=e,e}}}function qb(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var $b=0;function Yb(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function Zb(i){let t=new Xb,e=qb(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new X);let s=new X,r=new ke,o=new ke;function a(c){let h=0,u=0,f=0;for(let F=0;F<9;F++)n.probe[F].set(0,0,0);let d=0,m=0,y=0,p=0,g=0,v=0,A=0,M=0,P=0,E=0,_=0,T=0,k=0,U=0;c.sort(Yb);for(let F=0,G=c.length;F<G;F++){let D=c[F],V=D.color,$=D.intensity,H=D.distance,ct=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Js?ct=D.shadow.map.texture:ct=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=V.r*$,u+=V.g*$,f+=V.b*$;else if(D.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(D.sh.coefficients[J],$);U++}else if(D.isSunLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,rt=e.get(D);rt.shadowIntensity=Q.intensity,rt.shadowBias=Q.bias,rt.shadowNormalBias=Q.normalBias,rt.shadowRadius=Q.radius,rt.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[m]=rt,n.sunShadowMap[m]=ct;let dt=Q.getViewportCount();for(let ft=0;ft<dt;ft++)n.sunShadowMatrix[y+ft]=Q.getMatrix(ft),n.sunShadowCascade[y+ft]=Q._cascadeData[ft];y+=dt,m++}n.sun[d]=J,d++}else if(D.isDirectionalLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,rt=e.get(D);rt.shadowIntensity=Q.intensity,rt.shadowBias=Q.bias,rt.shadowNormalBias=Q.normalBias,rt.shadowRadius=Q.radius,rt.shadowMapSize=Q.mapSize,n.directionalShadow[p]=rt,n.directionalShadowMap[p]=ct,n.directionalShadowMatrix[p]=D.shadow.matrix,P++}n.directional[p]=J,p++}else if(D.isSpotLight){let J=t.get(D);J.position.setFromMatrixPosition(D.matrixWorld),J.color.copy(V).multiplyScalar($),J.distance=H,J.coneCos=Math.cos(D.angle),J.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),J.decay=D.decay,n.spot[v]=J;let Q=D.shadow;if(D.map&&(n.spotLightMap[T]=D.map,T++,Q.updateMatrices(D),D.castShadow&&k++),n.spotLightMatrix[v]=Q.matrix,D.castShadow){let rt=e.get(D);rt.shadowIntensity=Q.intensity,rt.shadowBias=Q.bias,rt.shadowNormalBias=Q.normalBias,rt.shadowRadius=Q.radius,rt.shadowMapSize=Q.mapSize,n.spotShadow[v]=rt,n.spotShadowMap[v]=ct,_++}v++}else if(D.isRectAreaLight){let J=t.get(D);J.color.copy(V).multiplyScalar($),J.halfWidth.set(D.width*.5,0,0),J.halfHeight.set(0,D.height*.5,0),n.rectArea[A]=J,A++}else if(D.isPointLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),J.distance=D.distance,J.decay=D.decay,D.castShadow){let Q=D.shadow,rt=e.get(D);rt.shadowIntensity=Q.intensity,rt.shadowBias=Q.bias,rt.shadowNormalBias=Q.normalBias,rt.shadowRadius=Q.radius,rt.shadowMapSize=Q.mapSize,rt.shadowCameraNear=Q.camera.near,rt.shadowCameraFar=Q.camera.far,n.pointShadow[g]=rt,n.pointShadowMap[g]=ct,n.pointShadowMatrix[g]=D.shadow.matrix,E++}n.point[g]=J,g++}else if(D.isHemisphereLight){let J=t.get(D);J.skyColor.copy(D.color).multiplyScalar($),J.groundColor.copy(D.groundColor).multiplyScalar($),n.hemi[M]=J,M++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Nt.LTC_FLOAT_1,n.rectAreaLTC2=Nt.LTC_FLOAT_2):(n.rectAreaLTC1=Nt.LTC_HALF_1,n.rectAreaLTC2=Nt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let C=n.hash;(C.sunLength!==d||C.directionalLength!==p||C.pointLength!==g||C.spotLength!==v||C.rectAreaLength!==A||C.hemiLength!==M||C.numSunShadows!==m||C.numDirectionalShadows!==P||C.numPointShadows!==E||C.numSpotShadows!==_||C.numSpotMaps!==T||C.numLightProbes!==U)&&(n.sun.length=d,n.directional.length=p,n.spot.length=v,n.rectArea.length=A,n.point.length=g,n.hemi.length=M,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=P,n.directionalShadowMap.length=P,n.directionalShadowMatrix.length=P,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+T-k,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=U,C.sunLength=d,C.directionalLength=p,C.pointLength=g,C.spotLength=v,C.rectAreaLength=A,C.hemiLength=M,C.numSunShadows=m,C.numDirectionalShadows=P,C.numPointShadows=E,C.numSpotShadows=_,C.numSpotMaps=T,C.numLightProbes=U,n.version=$b++)}function l(c,h){let u=0,f=0,d=0,m=0,y=0,p=0,g=h.matrixWorldInverse;for(let v=0,A=c.length;v<A;v++){let M=c[v];if(M.isSunLight){let P=n.sun[u];P.direction.setFromMatrixPosition(M.matrixWorld),P.direction.transformDirection(g),u++}else if(M.isDirectionalLight){let P=n.directional[f];P.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(g),f++}else if(M.isSpotLight){let P=n.spot[m];P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(g),P.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(g),m++}else if(M.isRectAreaLight){let P=n.rectArea[y];P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(g),o.identity(),r.copy(M.matrixWorld),r.premultiply(g),o.extractRotation(r),P.halfWidth.set(M.width*.5,0,0),P.halfHeight.set(0,M.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),y++}else if(M.isPointLight){let P=n.point[d];P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(g),d++}else if(M.isHemisphereLight){let P=n.hemi[p];P.direction.setFromMatrixPosition(M.matrixWorld),P.direction.transformDirection(g),p++}}}return{setup:a,setupView:l,state:n}}function Jm(i){let t=new Zb(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function Jb(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Jm(i),t.set(s,[a])):r>=o.length?(a=new Jm(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var Kb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,jb=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Qb=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],tw=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],Km=new ke,za=new X,_f=new X;function ew(i,t,e){let n=new Hs,s=new Yt,r=new Yt,o=new je,a=new uc,l=new fc,c={},h=e.maxTextureSize,u={[Zs]:ti,[ti]:Zs,[ii]:ii},f=new ts({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:Kb,fragmentShader:jb}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let m=new an;m.setAttribute("position",new Di(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Un(m,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=La;let g=this.type;this.render=function(E,_,T){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===qp&&(jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=La);let k=i.getRenderTarget(),U=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),F=i.state;F.setBlending(fr),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let G=g!==this.type;G&&_.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(V=>V.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,V=E.length;D<V;D++){let $=E[D],H=$.shadow;if(H===void 0){jt("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ct=H.getFrameExtents();s.multiply(ct),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,H.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=J,H.map===null||G===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===_o){if($.isPointLight){jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new di(s.x,s.y,{format:Js,type:Oi,minFilter:Kn,magFilter:Kn,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new Ms(s.x,s.y,Fi),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=ys,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Dn,H.map.depthTexture.magFilter=Dn}else $.isPointLight?(H.map=new Ga(s.x),H.map.depthTexture=new _a(s.x,Ui)):(H.map=new di(s.x,s.y),H.map.depthTexture=new Ms(s.x,s.y,Ui)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=ys,this.type===La?(H.map.depthTexture.compareFunction=J?nf:ef,H.map.depthTexture.minFilter=Kn,H.map.depthTexture.magFilter=Kn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Dn,H.map.depthTexture.magFilter=Dn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();$.isPointLight!==!0&&H.updateMatrices($,T);let rt=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:T.layers;for(let dt=0;dt<Q;dt++){let ft=H.getCamera(dt);if($.isPointLight){let et=H.camera,_t=H.matrix,vt=$.distance||et.far;vt!==et.far&&(et.far=vt,et.updateProjectionMatrix()),za.setFromMatrixPosition($.matrixWorld),et.position.copy(za),_f.copy(et.position),_f.add(Qb[dt]),et.up.copy(tw[dt]),et.lookAt(_f),et.updateMatrixWorld(),_t.makeTranslation(-za.x,-za.y,-za.z),Km.multiplyMatrices(et.projectionMatrix,et.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Km,et.coordinateSystem,et.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,dt),i.clear();else{dt===0&&(i.setRenderTarget(H.map),i.clear());let et=H.getViewport(dt);o.set(r.x*et.x,r.y*et.y,r.x*et.z,r.y*et.w),F.viewport(o)}n=H.getFrustum(dt),M(_,T,ft,$,rt,this.type)}H.isPointLightShadow!==!0&&this.type===_o&&v(H,T),H.needsUpdate=!1}g=this.type,p.needsUpdate=!1,i.setRenderTarget(k,U,C)};function v(E,_){let T=t.update(y);f.defines.VSM_SAMPLES!==E.blurSamples&&(f.defines.VSM_SAMPLES=E.blurSamples,d.defines.VSM_SAMPLES=E.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),E.mapPass===null?E.mapPass=new di(s.x,s.y,{format:Js,type:Oi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),f.uniforms.shadow_pass.value=E.map.depthTexture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(_,null,T,f,y,null),d.uniforms.shadow_pass.value=E.mapPass.texture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(_,null,T,d,y,null)}function A(E,_,T,k){let U=null,C=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(C!==void 0)U=C;else if(U=T.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let F=U.uuid,G=_.uuid,D=c[F];D===void 0&&(D={},c[F]=D);let V=D[G];V===void 0&&(V=U.clone(),D[G]=V,_.addEventListener("dispose",P)),U=V}if(U.visible=_.visible,U.wireframe=_.wireframe,k===_o?U.side=_.shadowSide!==null?_.shadowSide:_.side:U.side=_.shadowSide!==null?_.shadowSide:u[_.side],U.alphaMap=_.alphaMap,U.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,U.map=_.map,U.clipShadows=_.clipShadows,U.clippingPlanes=_.clippingPlanes,U.clipIntersection=_.clipIntersection,U.displacementMap=_.displacementMap,U.displacementScale=_.displacementScale,U.displacementBias=_.displacementBias,U.wireframeLinewidth=_.wireframeLinewidth,U.linewidth=_.linewidth,T.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let F=i.properties.get(U);F.light=T}return U}function M(E,_,T,k,U,C){if(E.visible===!1)return;if(E.layers.test(U)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&C===_o)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let D=t.update(E),V=E.material;if(Array.isArray(V)){let $=D.groups;for(let H=0,ct=$.length;H<ct;H++){let J=$[H],Q=V[J.materialIndex];if(Q&&Q.visible){let rt=A(E,Q,k,C);E.onBeforeShadow(i,E,_,T,D,rt,J),i.renderBufferDirect(T,null,D,rt,E,J),E.onAfterShadow(i,E,_,T,D,rt,J)}}}else if(V.visible){let $=A(E,V,k,C);E.onBeforeShadow(i,E,_,T,D,$,null),i.renderBufferDirect(T,null,D,$,E,null),E.onAfterShadow(i,E,_,T,D,$,null)}}let G=E.children;for(let D=0,V=G.length;D<V;D++)M(G[D],_,T,k,U,C)}function P(E){E.target.removeEventListener("dispose",P);for(let T in c){let k=c[T],U=E.target.uuid;U in k&&(k[U].dispose(),delete k[U])}}}function nw(i,t){function e(){let O=!1,ot=new je,it=null,Et=new je(0,0,0,0);return{setMask:function(xt){it!==xt&&!O&&(i.colorMask(xt,xt,xt,xt),it=xt)},setLocked:function(xt){O=xt},setClear:function(xt,bt,Xt,ee,ht){ht===!0&&(xt*=ee,bt*=ee,Xt*=ee),ot.set(xt,bt,Xt,ee),Et.equals(ot)===!1&&(i.clearColor(xt,bt,Xt,ee),Et.copy(ot))},reset:function(){O=!1,it=null,Et.set(-1,0,0,0)}}}function n(){let O=!1,ot=!1,it=null,Et=null,xt=null;return{setReversed:function(bt){if(ot!==bt){let Xt=t.get("EXT_clip_control");bt?Xt.clipControlEXT(Xt.LOWER_LEFT_EXT,Xt.ZERO_TO_ONE_EXT):Xt.clipControlEXT(Xt.LOWER_LEFT_EXT,Xt.NEGATIVE_ONE_TO_ONE_EXT),ot=bt;let ee=xt;xt=null,this.setClear(ee)}},getReversed:function(){return ot},setTest:function(bt){bt?wt(i.DEPTH_TEST):qt(i.DEPTH_TEST)},setMask:function(bt){it!==bt&&!O&&(i.depthMask(bt),it=bt)},setFunc:function(bt){if(ot&&(bt=Tm[bt]),Et!==bt){switch(bt){case ql:i.depthFunc(i.NEVER);break;case $l:i.depthFunc(i.ALWAYS);break;case Yl:i.depthFunc(i.LESS);break;case ro:i.depthFunc(i.LEQUAL);break;case Zl:i.depthFunc(i.EQUAL);break;case Jl:i.depthFunc(i.GEQUAL);break;case Kl:i.depthFunc(i.GREATER);break;case jl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Et=bt}},setLocked:function(bt){O=bt},setClear:function(bt){xt!==bt&&(xt=bt,ot&&(bt=1-bt),i.clearDepth(bt))},reset:function(){O=!1,it=null,Et=null,xt=null,ot=!1}}}function s(){let O=!1,ot=null,it=null,Et=null,xt=null,bt=null,Xt=null,ee=null,ht=null;return{setTest:function(zt){O||(zt?wt(i.STENCIL_TEST):qt(i.STENCIL_TEST))},setMask:function(zt){ot!==zt&&!O&&(i.stencilMask(zt),ot=zt)},setFunc:function(zt,ne,Pt){(it!==zt||Et!==ne||xt!==Pt)&&(i.stencilFunc(zt,ne,Pt),it=zt,Et=ne,xt=Pt)},setOp:function(zt,ne,Pt){(bt!==zt||Xt!==ne||ee!==Pt)&&(i.stencilOp(zt,ne,Pt),bt=zt,Xt=ne,ee=Pt)},setLocked:function(zt){O=zt},setClear:function(zt){ht!==zt&&(i.clearStencil(zt),ht=zt)},reset:function(){O=!1,ot=null,it=null,Et=null,xt=null,bt=null,Xt=null,ee=null,ht=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,m=[],y=null,p=!1,g=null,v=null,A=null,M=null,P=null,E=null,_=null,T=new he(0,0,0),k=0,U=!1,C=null,F=null,G=null,D=null,V=null,$=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ct=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(J)[1]),H=ct>=1):J.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),H=ct>=2);let Q=null,rt={},dt=i.getParameter(i.SCISSOR_BOX),ft=i.getParameter(i.VIEWPORT),et=new je().fromArray(dt),_t=new je().fromArray(ft);function vt(O,ot,it,Et){let xt=new Uint8Array(4),bt=i.createTexture();i.bindTexture(O,bt),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Xt=0;Xt<it;Xt++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(ot,0,i.RGBA,1,1,Et,0,i.RGBA,i.UNSIGNED_BYTE,xt):i.texImage2D(ot+Xt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xt);return bt}let Rt={};Rt[i.TEXTURE_2D]=vt(i.TEXTURE_2D,i.TEXTURE_2D,1),Rt[i.TEXTURE_CUBE_MAP]=vt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Rt[i.TEXTURE_2D_ARRAY]=vt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Rt[i.TEXTURE_3D]=vt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),wt(i.DEPTH_TEST),o.setFunc(ro),un(!1),Oe(Du),wt(i.CULL_FACE),Je(fr);function wt(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function qt(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function le(O,ot){return f[O]!==ot?(i.bindFramebuffer(O,ot),f[O]=ot,O===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ot),O===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ot),!0):!1}function Wt(O,ot){let it=m,Et=!1;if(O){it=d.get(ot),it===void 0&&(it=[],d.set(ot,it));let xt=O.textures;if(it.length!==xt.length||it[0]!==i.COLOR_ATTACHMENT0){for(let bt=0,Xt=xt.length;bt<Xt;bt++)it[bt]=i.COLOR_ATTACHMENT0+bt;it.length=xt.length,Et=!0}}else it[0]!==i.BACK&&(it[0]=i.BACK,Et=!0);Et&&i.drawBuffers(it)}function me(O){return y!==O?(i.useProgram(O),y=O,!0):!1}let fe={[dr]:i.FUNC_ADD,[Yp]:i.FUNC_SUBTRACT,[Zp]:i.FUNC_REVERSE_SUBTRACT};fe[Jp]=i.MIN,fe[Kp]=i.MAX;let oe={[jp]:i.ZERO,[Qp]:i.ONE,[tm]:i.SRC_COLOR,[Ou]:i.SRC_ALPHA,[om]:i.SRC_ALPHA_SATURATE,[sm]:i.DST_COLOR,[nm]:i.DST_ALPHA,[em]:i.ONE_MINUS_SRC_COLOR,[Bu]:i.ONE_MINUS_SRC_ALPHA,[rm]:i.ONE_MINUS_DST_COLOR,[im]:i.ONE_MINUS_DST_ALPHA,[am]:i.CONSTANT_COLOR,[lm]:i.ONE_MINUS_CONSTANT_COLOR,[cm]:i.CONSTANT_ALPHA,[hm]:i.ONE_MINUS_CONSTANT_ALPHA};function Je(O,ot,it,Et,xt,bt,Xt,ee,ht,zt){if(O===fr){p===!0&&(qt(i.BLEND),p=!1);return}if(p===!1&&(wt(i.BLEND),p=!0),O!==$p){if(O!==g||zt!==U){if((v!==dr||P!==dr)&&(i.blendEquation(i.FUNC_ADD),v=dr,P=dr),zt)switch(O){case xo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Nu:i.blendFunc(i.ONE,i.ONE);break;case Uu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Fu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ie("WebGLState: Invalid blending: ",O);break}else switch(O){case xo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Nu:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Uu:ie("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Fu:ie("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ie("WebGLState: Invalid blending: ",O);break}A=null,M=null,E=null,_=null,T.set(0,0,0),k=0,g=O,U=zt}return}xt=xt||ot,bt=bt||it,Xt=Xt||Et,(ot!==v||xt!==P)&&(i.blendEquationSeparate(fe[ot],fe[xt]),v=ot,P=xt),(it!==A||Et!==M||bt!==E||Xt!==_)&&(i.blendFuncSeparate(oe[it],oe[Et],oe[bt],oe[Xt]),A=it,M=Et,E=bt,_=Xt),(ee.equals(T)===!1||ht!==k)&&(i.blendColor(ee.r,ee.g,ee.b,ht),T.copy(ee),k=ht),g=O,U=!1}function He(O,ot){O.side===ii?qt(i.CULL_FACE):wt(i.CULL_FACE);let it=O.side===ti;ot&&(it=!it),un(it),O.blending===xo&&O.transparent===!1?Je(fr):Je(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Et=O.stencilWrite;a.setTest(Et),Et&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),be(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?wt(i.SAMPLE_ALPHA_TO_COVERAGE):qt(i.SAMPLE_ALPHA_TO_COVERAGE)}function un(O){C!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),C=O)}function Oe(O){O!==Wp?(wt(i.CULL_FACE),O!==F&&(O===Du?i.cullFace(i.BACK):O===Xp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):qt(i.CULL_FACE),F=O}function An(O){O!==G&&(H&&i.lineWidth(O),G=O)}function be(O,ot,it){O?(wt(i.POLYGON_OFFSET_FILL),(D!==ot||V!==it)&&(D=ot,V=it,o.getReversed()&&(ot=-ot,it=-it),i.polygonOffset(ot,it))):qt(i.POLYGON_OFFSET_FILL)}function yn(O){O?wt(i.SCISSOR_TEST):qt(i.SCISSOR_TEST)}function en(O){O===void 0&&(O=i.TEXTURE0+$-1),Q!==O&&(i.activeTexture(O),Q=O)}function fn(O,ot,it){it===void 0&&(Q===null?it=i.TEXTURE0+$-1:it=Q);let Et=rt[it];Et===void 0&&(Et={type:void 0,texture:void 0},rt[it]=Et),(Et.type!==O||Et.texture!==ot)&&(Q!==it&&(i.activeTexture(it),Q=it),i.bindTexture(O,ot||Rt[O]),Et.type=O,Et.texture=ot)}function B(){let O=rt[Q];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function It(){try{i.compressedTexImage2D(...arguments)}catch(O){ie("WebGLState:",O)}}function Qt(){try{i.compressedTexImage3D(...arguments)}catch(O){ie("WebGLState:",O)}}function ce(){try{i.texSubImage2D(...arguments)}catch(O){ie("WebGLState:",O)}}function Tt(){try{i.texSubImage3D(...arguments)}catch(O){ie("WebGLState:",O)}}function ze(){try{i.compressedTexSubImage2D(...arguments)}catch(O){ie("WebGLState:",O)}}function Ht(){try{i.compressedTexSubImage3D(...arguments)}catch(O){ie("WebGLState:",O)}}function Kt(){try{i.texStorage2D(...arguments)}catch(O){ie("WebGLState:",O)}}function I(){try{i.texStorage3D(...arguments)}catch(O){ie("WebGLState:",O)}}function S(){try{i.texImage2D(...arguments)}catch(O){ie("WebGLState:",O)}}function q(){try{i.texImage3D(...arguments)}catch(O){ie("WebGLState:",O)}}function ut(O){return u[O]!==void 0?u[O]:i.getParameter(O)}function at(O,ot){u[O]!==ot&&(i.pixelStorei(O,ot),u[O]=ot)}function yt(O){et.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),et.copy(O))}function St(O){_t.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),_t.copy(O))}function nt(O,ot){let it=c.get(ot);it===void 0&&(it=new WeakMap,c.set(ot,it));let Et=it.get(O);Et===void 0&&(Et=i.getUniformBlockIndex(ot,O.name),i.uniformBlockBinding(ot,Et,Et),it.set(O,Et))}function st(O,ot,it){let xt=c.get(ot).get(O);l[xt]!==it&&(i.bindBufferBase(i.UNIFORM_BUFFER,xt,it),l[xt]=it)}function gt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,rt={},f={},l={},d=new WeakMap,m=[],y=null,p=!1,g=null,v=null,A=null,M=null,P=null,E=null,_=null,T=new he(0,0,0),k=0,U=!1,C=null,F=null,G=null,D=null,V=null,et.set(0,0,i.canvas.width,i.canvas.height),_t.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:wt,disable:qt,bindFramebuffer:le,drawBuffers:Wt,useProgram:me,setBlending:Je,setMaterial:He,setFlipSided:un,setCullFace:Oe,setLineWidth:An,setPolygonOffset:be,setScissorTest:yn,activeTexture:en,bindTexture:fn,unbindTexture:B,compressedTexImage2D:It,compressedTexImage3D:Qt,texImage2D:S,texImage3D:q,pixelStorei:at,getParameter:ut,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:Kt,texStorage3D:I,texSubImage2D:ce,texSubImage3D:Tt,compressedTexSubImage2D:ze,compressedTexSubImage3D:Ht,scissor:yt,viewport:St,reset:gt}}function iw(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Yt,h=new WeakMap,u=new Set,f,d=new WeakMap,m=new Set,y=new FinalizationRegistry(I=>m.delete(I)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,S){return p?new OffscreenCanvas(I,S):oa("canvas")}function v(I,S,q){let ut=1,at=Kt(I);if((at.width>q||at.height>q)&&(ut=q/Math.max(at.width,at.height)),ut<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let yt=Math.floor(ut*at.width),St=Math.floor(ut*at.height);f===void 0&&(f=g(yt,St));let nt=S?g(yt,St):f;return nt.width=yt,nt.height=St,nt.getContext("2d").drawImage(I,0,0,yt,St),jt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+yt+"x"+St+")."),nt}else return"data"in I&&jt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),I;return I}function A(I){return I.generateMipmaps}function M(I){i.generateMipmap(I)}function P(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(I,S,q,ut,at,yt=!1){if(I!==null){if(i[I]!==void 0)return i[I];jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let St;ut&&(St=t.get("EXT_texture_norm16"),St||jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=S;if(S===i.RED&&(q===i.FLOAT&&(nt=i.R32F),q===i.HALF_FLOAT&&(nt=i.R16F),q===i.UNSIGNED_BYTE&&(nt=i.R8),q===i.UNSIGNED_SHORT&&St&&(nt=St.R16_EXT),q===i.SHORT&&St&&(nt=St.R16_SNORM_EXT)),S===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.R8UI),q===i.UNSIGNED_SHORT&&(nt=i.R16UI),q===i.UNSIGNED_INT&&(nt=i.R32UI),q===i.BYTE&&(nt=i.R8I),q===i.SHORT&&(nt=i.R16I),q===i.INT&&(nt=i.R32I)),S===i.RG&&(q===i.FLOAT&&(nt=i.RG32F),q===i.HALF_FLOAT&&(nt=i.RG16F),q===i.UNSIGNED_BYTE&&(nt=i.RG8),q===i.UNSIGNED_SHORT&&St&&(nt=St.RG16_EXT),q===i.SHORT&&St&&(nt=St.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RG8UI),q===i.UNSIGNED_SHORT&&(nt=i.RG16UI),q===i.UNSIGNED_INT&&(nt=i.RG32UI),q===i.BYTE&&(nt=i.RG8I),q===i.SHORT&&(nt=i.RG16I),q===i.INT&&(nt=i.RG32I)),S===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RGB8UI),q===i.UNSIGNED_SHORT&&(nt=i.RGB16UI),q===i.UNSIGNED_INT&&(nt=i.RGB32UI),q===i.BYTE&&(nt=i.RGB8I),q===i.SHORT&&(nt=i.RGB16I),q===i.INT&&(nt=i.RGB32I)),S===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(nt=i.RGBA16UI),q===i.UNSIGNED_INT&&(nt=i.RGBA32UI),q===i.BYTE&&(nt=i.RGBA8I),q===i.SHORT&&(nt=i.RGBA16I),q===i.INT&&(nt=i.RGBA32I)),S===i.RGB&&(q===i.UNSIGNED_SHORT&&St&&(nt=St.RGB16_EXT),q===i.SHORT&&St&&(nt=St.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(nt=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(nt=i.R11F_G11F_B10F)),S===i.RGBA){let st=yt?ra:Se.getTransfer(at);q===i.FLOAT&&(nt=i.RGBA32F),q===i.HALF_FLOAT&&(nt=i.RGBA16F),q===i.UNSIGNED_BYTE&&(nt=st===Ie?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&St&&(nt=St.RGBA16_EXT),q===i.SHORT&&St&&(nt=St.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(nt=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(nt=i.RGB5_A1)}return(nt===i.R16F||nt===i.R32F||nt===i.RG16F||nt===i.RG32F||nt===i.RGBA16F||nt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function _(I,S){let q;return I?S===null||S===Ui||S===mr?q=i.DEPTH24_STENCIL8:S===Fi?q=i.DEPTH32F_STENCIL8:S===vo&&(q=i.DEPTH24_STENCIL8,jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Ui||S===mr?q=i.DEPTH_COMPONENT24:S===Fi?q=i.DEPTH_COMPONENT32F:S===vo&&(q=i.DEPTH_COMPONENT16),q}function T(I,S){return A(I)===!0||I.isFramebufferTexture&&I.minFilter!==Dn&&I.minFilter!==Kn?Math.log2(Math.max(S.width,S.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?S.mipmaps.length:1}function k(I){let S=new WeakRef(I);n.get(I).__ref=S,m.add(S),y.register(I,S,S)}function U(I){let S=n.get(I).__ref;S!==void 0&&(m.delete(S),y.unregister(S))}function C(I){G(I.target)}function F(I){D(I.target)}function G(I){I.removeEventListener("dispose",C),U(I),$(I),I.isVideoTexture&&h.delete(I),I.isHTMLTexture&&u.delete(I)}function D(I){I.removeEventListener("dispose",F),U(I),ct(I)}function V(){for(let I of m){let S=I.deref();S!==void 0&&(S.isRenderTarget===!0?D(S):G(S))}m.clear(),u.clear()}function $(I){let S=n.get(I);if(S.__webglInit===void 0)return;let q=I.source,ut=d.get(q);if(ut){let at=ut[S.__cacheKey];at.usedTimes--,at.usedTimes===0&&H(I),Object.keys(ut).length===0&&d.delete(q)}n.remove(I)}function H(I){let S=n.get(I);i.deleteTexture(S.__webglTexture);let q=I.source,ut=d.get(q);delete ut[S.__cacheKey],o.memory.textures--}function ct(I){let S=n.get(I);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=I.depthTexture;if(q&&q.renderTarget===I&&G(q),I.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(S.__webglFramebuffer[at]))for(let yt=0;yt<S.__webglFramebuffer[at].length;yt++)i.deleteFramebuffer(S.__webglFramebuffer[at][yt]);else i.deleteFramebuffer(S.__webglFramebuffer[at]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[at])}else{if(Array.isArray(S.__webglFramebuffer))for(let at=0;at<S.__webglFramebuffer.length;at++)i.deleteFramebuffer(S.__webglFramebuffer[at]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let at=0;at<S.__webglColorRenderbuffer.length;at++)S.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[at]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ut=I.textures;for(let at=0,yt=ut.length;at<yt;at++){let St=n.get(ut[at]);St.__webglTexture&&(i.deleteTexture(St.__webglTexture),o.memory.textures--),n.remove(ut[at])}n.remove(I)}let J=0;function Q(){J=0}function rt(){return J}function dt(I){J=I}function ft(){let I=J;return I>=s.maxTextures&&jt("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,I}function et(I){let S=[];return S.push(I.wrapS),S.push(I.wrapT),S.push(I.wrapR||0),S.push(I.magFilter),S.push(I.minFilter),S.push(I.anisotropy),S.push(I.internalFormat),S.push(I.format),S.push(I.type),S.push(I.generateMipmaps),S.push(I.mipmapsAutoUpdate),S.push(I.premultiplyAlpha),S.push(I.flipY),S.push(I.unpackAlignment),S.push(I.colorSpace),S.join()}function _t(I,S){let q=n.get(I);if(I.isVideoTexture&&ze(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&q.__version!==I.version){let ut=I.image;if(ut===null)jt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)jt("WebGLRenderer: Texture marked for update but image is incomplete");else{He(q,I,S);return}}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+S)}function vt(I,S){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){He(q,I,S);return}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+S)}function Rt(I,S){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){He(q,I,S);return}e.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+S)}function wt(I,S){let q=n.get(I);if(I.version>0&&q.__version!==I.version){un(q,I,S);return}e.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+S)}let qt={[Ql]:i.REPEAT,[Ki]:i.CLAMP_TO_EDGE,[tc]:i.MIRRORED_REPEAT},le={[Dn]:i.NEAREST,[dm]:i.NEAREST_MIPMAP_NEAREST,[Da]:i.NEAREST_MIPMAP_LINEAR,[Kn]:i.LINEAR,[Ac]:i.LINEAR_MIPMAP_NEAREST,[ws]:i.LINEAR_MIPMAP_LINEAR},Wt={[_m]:i.NEVER,[sf]:i.ALWAYS,[xm]:i.LESS,[ef]:i.LEQUAL,[ym]:i.EQUAL,[nf]:i.GEQUAL,[vm]:i.GREATER,[Sm]:i.NOTEQUAL};function me(I,S){if(S.type===Fi&&t.has("OES_texture_float_linear")===!1&&(S.magFilter===Kn||S.magFilter===Ac||S.magFilter===Da||S.magFilter===ws||S.minFilter===Kn||S.minFilter===Ac||S.minFilter===Da||S.minFilter===ws)&&jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,qt[S.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,qt[S.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,qt[S.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,le[S.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,le[S.minFilter]),S.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,Wt[S.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Dn||S.minFilter!==Da&&S.minFilter!==ws||S.type===Fi&&t.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");i.texParameterf(I,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function fe(I,S){let q=!1;I.__webglInit===void 0&&(I.__webglInit=!0,S.addEventListener("dispose",C),k(S));let ut=S.source,at=d.get(ut);at===void 0&&(at={},d.set(ut,at));let yt=et(S);if(yt!==I.__cacheKey){at[yt]===void 0&&(at[yt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),at[yt].usedTimes++;let St=at[I.__cacheKey];St!==void 0&&(at[I.__cacheKey].usedTimes--,St.usedTimes===0&&H(S)),I.__cacheKey=yt,I.__webglTexture=at[yt].texture}return q}function oe(I,S,q){return Math.floor(Math.floor(I/q)/S)}function Je(I,S,q,ut){let yt=I.updateRanges;if(yt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,q,ut,S.data);else{yt.sort((O,ot)=>O.start-ot.start);let St=0;for(let O=1;O<yt.length;O++){let ot=yt[St],it=yt[O],Et=ot.start+ot.count,xt=oe(it.start,S.width,4),bt=oe(ot.start,S.width,4);it.start<=Et+1&&xt===bt&&oe(it.start+it.count-1,S.width,4)===xt?ot.count=Math.max(ot.count,it.start+it.count-ot.start):(++St,yt[St]=it)}yt.length=St+1;let nt=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),gt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let O=0,ot=yt.length;O<ot;O++){let it=yt[O],Et=Math.floor(it.start/4),xt=Math.ceil(it.count/4),bt=Et%S.width,Xt=Math.floor(Et/S.width),ee=xt,ht=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Xt),e.texSubImage2D(i.TEXTURE_2D,0,bt,Xt,ee,ht,q,ut,S.data)}I.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,nt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,gt)}}function He(I,S,q){let ut=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ut=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ut=i.TEXTURE_3D);let at=fe(I,S),yt=S.source;e.bindTexture(ut,I.__webglTexture,i.TEXTURE0+q);let St=n.get(yt);if(yt.version!==St.__version||at===!0){if(e.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ht=Se.getPrimaries(Se.workingColorSpace),zt=S.colorSpace===Es?null:Se.getPrimaries(S.colorSpace),ne=S.colorSpace===Es||ht===zt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne)}e.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let st=v(S.image,!1,s.maxTextureSize);st=Ht(S,st);let gt=r.convert(S.format,S.colorSpace),O=r.convert(S.type),ot=E(S.internalFormat,gt,O,S.normalized,S.colorSpace,S.isVideoTexture);me(ut,S);let it,Et=S.mipmaps,xt=S.isVideoTexture!==!0,bt=St.__version===void 0||at===!0,Xt=yt.dataReady,ee=T(S,st);if(S.isDepthTexture)ot=_(S.format===Ts,S.type),bt&&(xt?e.texStorage2D(i.TEXTURE_2D,1,ot,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,ot,st.width,st.height,0,gt,O,null));else if(S.isDataTexture)if(Et.length>0){xt&&bt&&e.texStorage2D(i.TEXTURE_2D,ee,ot,Et[0].width,Et[0].height);for(let ht=0,zt=Et.length;ht<zt;ht++)it=Et[ht],xt?Xt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,it.width,it.height,gt,O,it.data):e.texImage2D(i.TEXTURE_2D,ht,ot,it.width,it.height,0,gt,O,it.data);S.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(i.TEXTURE_2D,ee,ot,st.width,st.height),Xt&&Je(S,st,gt,O)):e.texImage2D(i.TEXTURE_2D,0,ot,st.width,st.height,0,gt,O,st.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ee,ot,Et[0].width,Et[0].height,st.depth);for(let ht=0,zt=Et.length;ht<zt;ht++)if(it=Et[ht],S.format!==Bi)if(gt!==null)if(xt){if(Xt)if(S.layerUpdates.size>0){let ne=mf(it.width,it.height,S.format,S.type);for(let Pt of S.layerUpdates){let ue=it.data.subarray(Pt*ne/it.data.BYTES_PER_ELEMENT,(Pt+1)*ne/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,Pt,it.width,it.height,1,gt,ue)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,0,it.width,it.height,st.depth,gt,it.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ht,ot,it.width,it.height,st.depth,0,it.data,0,0);else jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Xt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,0,it.width,it.height,st.depth,gt,O,it.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ht,ot,it.width,it.height,st.depth,0,gt,O,it.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(i.TEXTURE_2D,ee,ot,Et[0].width,Et[0].height);for(let ht=0,zt=Et.length;ht<zt;ht++)it=Et[ht],S.format!==Bi?gt!==null?xt?Xt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ht,0,0,it.width,it.height,gt,it.data):e.compressedTexImage2D(i.TEXTURE_2D,ht,ot,it.width,it.height,0,it.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Xt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,it.width,it.height,gt,O,it.data):e.texImage2D(i.TEXTURE_2D,ht,ot,it.width,it.height,0,gt,O,it.data)}else if(S.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ee,ot,st.width,st.height,st.depth),Xt)if(S.layerUpdates.size>0){let ht=mf(st.width,st.height,S.format,S.type);for(let zt of S.layerUpdates){let ne=st.data.subarray(zt*ht/st.data.BYTES_PER_ELEMENT,(zt+1)*ht/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,zt,st.width,st.height,1,gt,O,ne)}S.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,gt,O,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,ot,st.width,st.height,st.depth,0,gt,O,st.data);else if(S.isData3DTexture)xt?(bt&&e.texStorage3D(i.TEXTURE_3D,ee,ot,st.width,st.height,st.depth),Xt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,gt,O,st.data)):e.texImage3D(i.TEXTURE_3D,0,ot,st.width,st.height,st.depth,0,gt,O,st.data);else if(S.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(i.TEXTURE_2D,ee,ot,st.width,st.height);else{let ht=st.width,zt=st.height;for(let ne=0;ne<ee;ne++)e.texImage2D(i.TEXTURE_2D,ne,ot,ht,zt,0,gt,O,null),ht>>=1,zt>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let ht=i.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),st.parentNode!==ht){ht.appendChild(st),u.add(S),ht.onpaint=zt=>{let ne=zt.changedElements;for(let Pt of u)ne.includes(Pt.image)&&(Pt.needsUpdate=!0)},ht.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let ne=i.RGBA,Pt=i.RGBA,ue=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ne,Pt,ue,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Et.length>0){if(xt&&bt){let ht=Kt(Et[0]);e.texStorage2D(i.TEXTURE_2D,ee,ot,ht.width,ht.height)}for(let ht=0,zt=Et.length;ht<zt;ht++)it=Et[ht],xt?Xt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,gt,O,it):e.texImage2D(i.TEXTURE_2D,ht,ot,gt,O,it);S.generateMipmaps=!1}else if(xt){if(bt){let ht=Kt(st);e.texStorage2D(i.TEXTURE_2D,ee,ot,ht.width,ht.height)}Xt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,gt,O,st)}else e.texImage2D(i.TEXTURE_2D,0,ot,gt,O,st);A(S)&&S.mipmapsAutoUpdate===!0&&M(ut),St.__version=yt.version,S.onUpdate&&S.onUpdate(S)}I.__version=S.version}function un(I,S,q){if(S.image.length!==6)return;let ut=fe(I,S),at=S.source;e.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+q);let yt=n.get(at);if(at.version!==yt.__version||ut===!0){e.activeTexture(i.TEXTURE0+q);let St=Se.getPrimaries(Se.workingColorSpace),nt=S.colorSpace===Es?null:Se.getPrimaries(S.colorSpace),st=S.colorSpace===Es||St===nt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let gt=S.isCompressedTexture||S.image[0].isCompressedTexture,O=S.image[0]&&S.image[0].isDataTexture,ot=[];for(let Pt=0;Pt<6;Pt++)!gt&&!O?ot[Pt]=v(S.image[Pt],!0,s.maxCubemapSize):ot[Pt]=O?S.image[Pt].image:S.image[Pt],ot[Pt]=Ht(S,ot[Pt]);let it=ot[0],Et=r.convert(S.format,S.colorSpace),xt=r.convert(S.type),bt=E(S.internalFormat,Et,xt,S.normalized,S.colorSpace),Xt=S.isVideoTexture!==!0,ee=yt.__version===void 0||ut===!0,ht=at.dataReady,zt=T(S,it);me(i.TEXTURE_CUBE_MAP,S);let ne;if(S.isDepthTexture){if(bt=_(S.format===Ts,S.type),ee)if(Xt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,bt,it.width,it.height);else for(let Pt=0;Pt<6;Pt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,bt,it.width,it.height,0,Et,xt,null)}else if(gt){Xt&&ee&&e.texStorage2D(i.TEXTURE_CUBE_MAP,zt,bt,it.width,it.height);for(let Pt=0;Pt<6;Pt++){ne=ot[Pt].mipmaps;for(let ue=0;ue<ne.length;ue++){let We=ne[ue];S.format!==Bi?Et!==null?Xt?ht&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ue,0,0,We.width,We.height,Et,We.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ue,bt,We.width,We.height,0,We.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ue,0,0,We.width,We.height,Et,xt,We.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ue,bt,We.width,We.height,0,Et,xt,We.data)}}}else{if(ne=S.mipmaps,Xt&&ee){ne.length>0&&zt++;let Pt=Kt(ot[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,zt,bt,Pt.width,Pt.height)}for(let Pt=0;Pt<6;Pt++)if(O){Xt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,0,0,ot[Pt].width,ot[Pt].height,Et,xt,ot[Pt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,bt,ot[Pt].width,ot[Pt].height,0,Et,xt,ot[Pt].data);for(let ue=0;ue<ne.length;ue++){let Hn=ne[ue].image[Pt].image;Xt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ue+1,0,0,Hn.width,Hn.height,Et,xt,Hn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ue+1,bt,Hn.width,Hn.height,0,Et,xt,Hn.data)}}else{Xt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,0,0,Et,xt,ot[Pt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,bt,Et,xt,ot[Pt]);for(let ue=0;ue<ne.length;ue++){let We=ne[ue];Xt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ue+1,0,0,Et,xt,We.image[Pt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,ue+1,bt,Et,xt,We.image[Pt])}}}A(S)&&S.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),yt.__version=at.version,S.onUpdate&&S.onUpdate(S)}I.__version=S.version}function Oe(I,S,q,ut,at,yt){let St=r.convert(q.format,q.colorSpace),nt=r.convert(q.type),st=E(q.internalFormat,St,nt,q.normalized,q.colorSpace),gt=n.get(S),O=n.get(q);if(O.__renderTarget=S,!gt.__hasExternalTextures){let ot=Math.max(1,S.width>>yt),it=Math.max(1,S.height>>yt);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,yt,st,ot,it,S.depth,0,St,nt,null):e.texImage2D(at,yt,st,ot,it,0,St,nt,null)}e.bindFramebuffer(i.FRAMEBUFFER,I),Tt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ut,at,O.__webglTexture,0,ce(S)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ut,at,O.__webglTexture,yt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function An(I,S,q){if(i.bindRenderbuffer(i.RENDERBUFFER,I),S.depthBuffer){let ut=S.depthTexture,at=ut&&ut.isDepthTexture?ut.type:null,yt=_(S.stencilBuffer,at),St=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Tt(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(S),yt,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(S),yt,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,yt,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,St,i.RENDERBUFFER,I)}else{let ut=S.textures;for(let at=0;at<ut.length;at++){let yt=ut[at],St=r.convert(yt.format,yt.colorSpace),nt=r.convert(yt.type),st=E(yt.internalFormat,St,nt,yt.normalized,yt.colorSpace);Tt(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(S),st,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(S),st,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,st,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function be(I,S,q){let ut=S.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,I),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(S.depthTexture);at.__renderTarget=S;let yt=ut?S.depthTexture.image[0]:S.depthTexture.image;(!at.__webglTexture||yt.width!==S.width||yt.height!==S.height)&&(yt.width=S.width,yt.height=S.height,S.depthTexture.needsUpdate=!0),ut?wt(S.depthTexture,0):_t(S.depthTexture,0);let St=at.__webglTexture,nt=ce(S),st=ut?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,gt=S.depthTexture.format===Ts?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===ys)Tt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,gt,st,St,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,gt,st,St,0);else if(S.depthTexture.format===Ts)Tt(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,gt,st,St,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,gt,st,St,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function yn(I){let S=n.get(I),q=I.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==I.depthTexture){let ut=I.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ut){let at=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ut.removeEventListener("dispose",at)};ut.addEventListener("dispose",at),S.__depthDisposeCallback=at}S.__boundDepthTexture=ut}if(I.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ut=0;ut<6;ut++)be(S.__webglFramebuffer[ut],I,ut);else I.texture.mipmaps.length>0?be(S.__webglFramebuffer[0],I,0):be(S.__webglFramebuffer,I,0);else if(q){S.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ut]),S.__webglDepthbuffer[ut]===void 0)S.__webglDepthbuffer[ut]=i.createRenderbuffer(),An(S.__webglDepthbuffer[ut],I,!1);else{let at=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=S.__webglDepthbuffer[ut];i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,yt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),An(S.__webglDepthbuffer,I,!1);else{let at=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,yt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function en(I,S,q){let ut=n.get(I);S!==void 0&&Oe(ut.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&yn(I)}function fn(I){let S=I.texture,q=n.get(I),ut=n.get(S);I.addEventListener("dispose",F),k(I);let at=I.textures,yt=I.isWebGLCubeRenderTarget===!0,St=at.length>1;if(St||(ut.__webglTexture===void 0&&(ut.__webglTexture=i.createTexture()),ut.__version=S.version,o.memory.textures++),yt){q.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(S.mipmaps.length>0){q.__webglFramebuffer[nt]=[];for(let st=0;st<S.mipmaps.length;st++)q.__webglFramebuffer[nt][st]=i.createFramebuffer()}else q.__webglFramebuffer[nt]=i.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let nt=0;nt<S.mipmaps.length;nt++)q.__webglFramebuffer[nt]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(St)for(let nt=0,st=at.length;nt<st;nt++){let gt=n.get(at[nt]);gt.__webglTexture===void 0&&(gt.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&Tt(I)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];q.__webglColorRenderbuffer[nt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[nt]);let gt=r.convert(st.format,st.colorSpace),O=r.convert(st.type),ot=E(st.internalFormat,gt,O,st.normalized,st.colorSpace,I.isXRRenderTarget===!0),it=ce(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,it,ot,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+nt,i.RENDERBUFFER,q.__webglColorRenderbuffer[nt])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),An(q.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(yt){e.bindTexture(i.TEXTURE_CUBE_MAP,ut.__webglTexture),me(i.TEXTURE_CUBE_MAP,S);for(let nt=0;nt<6;nt++)if(S.mipmaps.length>0)for(let st=0;st<S.mipmaps.length;st++)Oe(q.__webglFramebuffer[nt][st],I,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Oe(q.__webglFramebuffer[nt],I,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);A(S)?M(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}else if(St){for(let nt=0,st=at.length;nt<st;nt++){let gt=at[nt],O=n.get(gt),ot=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ot=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(ot,O.__webglTexture),me(ot,gt),Oe(q.__webglFramebuffer,I,gt,i.COLOR_ATTACHMENT0+nt,ot,0),A(gt)&&M(ot)}e.unbindTexture()}else{let nt=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(nt=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(nt,ut.__webglTexture),me(nt,S),S.mipmaps.length>0)for(let st=0;st<S.mipmaps.length;st++)Oe(q.__webglFramebuffer[st],I,S,i.COLOR_ATTACHMENT0,nt,st);else Oe(q.__webglFramebuffer,I,S,i.COLOR_ATTACHMENT0,nt,0);A(S)?M(nt):S.mipmaps.length>0&&i.texParameteri(nt,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&yn(I)}function B(I){let S=I.textures;for(let q=0,ut=S.length;q<ut;q++){let at=S[q];if(A(at)&&at.mipmapsAutoUpdate===!0){let yt=P(I),St=n.get(at).__webglTexture;e.bindTexture(yt,St),M(yt),e.unbindTexture()}}}let It=[];function Qt(I){if(I.samples>0){if(Tt(I)===!1){let S=I.textures,q=I.width,ut=I.height,at=i.COLOR_BUFFER_BIT,yt=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,St=n.get(I),nt=S.length>1;if(nt)for(let gt=0;gt<S.length;gt++)e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let gt=0;gt<S.length;gt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),nt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,St.__webglColorRenderbuffer[gt]);let O=n.get(S[gt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,O,0)}i.blitFramebuffer(0,0,q,ut,0,0,q,ut,at,i.NEAREST),l===!0&&(It.length=0,It.push(i.COLOR_ATTACHMENT0+gt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&It.push(yt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,It))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),nt)for(let gt=0;gt<S.length;gt++){e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,St.__webglColorRenderbuffer[gt]);let O=n.get(S[gt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,O,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let S=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function ce(I){return Math.min(s.maxSamples,I.samples)}function Tt(I){let S=n.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function ze(I){let S=o.render.frame;h.get(I)!==S&&(h.set(I,S),I.update())}function Ht(I,S){let q=I.colorSpace,ut=I.format,at=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||q!==sa&&q!==Es&&(Se.getTransfer(q)===Ie?(ut!==Bi||at!==si)&&jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ie("WebGLTextures: Unsupported texture color space:",q)),S}function Kt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=Q,this.getTextureUnits=rt,this.setTextureUnits=dt,this.setTexture2D=_t,this.setTexture2DArray=vt,this.setTexture3D=Rt,this.setTextureCube=wt,this.rebindTextures=en,this.setupRenderTarget=fn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Qt,this.setupDepthRenderbuffer=yn,this.setupFrameBufferTexture=Oe,this.useMultisampledRTT=Tt,this.dispose=V}function sw(i,t){function e(n,s=Es){let r,o=Se.getTransfer(s);if(n===si)return i.UNSIGNED_BYTE;if(n===Rc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Pc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Ju)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Ku)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Yu)return i.BYTE;if(n===Zu)return i.SHORT;if(n===vo)return i.UNSIGNED_SHORT;if(n===Cc)return i.INT;if(n===Ui)return i.UNSIGNED_INT;if(n===Fi)return i.FLOAT;if(n===Oi)return i.HALF_FLOAT;if(n===ju)return i.ALPHA;if(n===Qu)return i.RGB;if(n===Bi)return i.RGBA;if(n===ys)return i.DEPTH_COMPONENT;if(n===Ts)return i.DEPTH_STENCIL;if(n===tf)return i.RED;if(n===Ic)return i.RED_INTEGER;if(n===Js)return i.RG;if(n===Lc)return i.RG_INTEGER;if(n===Dc)return i.RGBA_INTEGER;if(n===Na||n===Ua||n===Fa||n===Oa)if(o===Ie)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Na)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ua)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Fa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Oa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Na)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ua)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Fa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Oa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Nc||n===Uc||n===Fc||n===Oc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Nc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Uc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Fc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Oc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Bc||n===kc||n===zc||n===Vc||n===Gc||n===Ba||n===Hc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Bc||n===kc)return o===Ie?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===zc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Vc)return r.COMPRESSED_R11_EAC;if(n===Gc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ba)return r.COMPRESSED_RG11_EAC;if(n===Hc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Wc||n===Xc||n===qc||n===$c||n===Yc||n===Zc||n===Jc||n===Kc||n===jc||n===Qc||n===th||n===eh||n===nh||n===ih)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Wc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Xc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===qc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===$c)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Yc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Zc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Jc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Kc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===jc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Qc)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===th)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===eh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===nh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ih)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===sh||n===rh||n===oh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===sh)return o===Ie?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===rh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===oh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===ah||n===lh||n===ka||n===ch)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===ah)return r.COMPRESSED_RED_RGTC1_EXT;if(n===lh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ka)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===ch)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===mr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var rw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,ow=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,wf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new xa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new ts({vertexShader:rw,fragmentShader:ow,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Un(new va(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Tf=class extends Ni{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,m=null,y=typeof XRWebGLBinding<"u",p=new wf,g={},v=e.getContextAttributes(),A=null,M=null,P=[],E=[],_=new Yt,T=null,k=null,U=new Jn;U.viewport=new je;let C=new Jn;C.viewport=new je;let F=[U,C],G=new wc,D=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(et){let _t=P[et];return _t===void 0&&(_t=new ho,P[et]=_t),_t.getTargetRaySpace()},this.getControllerGrip=function(et){let _t=P[et];return _t===void 0&&(_t=new ho,P[et]=_t),_t.getGripSpace()},this.getHand=function(et){let _t=P[et];return _t===void 0&&(_t=new ho,P[et]=_t),_t.getHandSpace()};function $(et){let _t=E.indexOf(et.inputSource);if(_t===-1)return;let vt=P[_t];vt!==void 0&&(vt.update(et.inputSource,et.frame,c||o),vt.dispatchEvent({type:et.type,data:et.inputSource}))}function H(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ct);for(let et=0;et<P.length;et++){let _t=E[et];_t!==null&&(E[et]=null,P[et].disconnect(_t))}D=null,V=null,p.reset();for(let et in g)delete g[et];if(t.setRenderTarget(A),d=null,f=null,u=null,s=null,M=null,ft.stop(),n.isPresenting=!1,t.setPixelRatio(T),t.setSize(_.width,_.height,!1),k!==null){let et=k.camera;et.fov=k.fov,et.zoom=k.zoom,et.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(et){r=et,n.isPresenting===!0&&jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(et){a=et,n.isPresenting===!0&&jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(et){c=et},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(et){if(s=et,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ct),v.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let vt=null,Rt=null,wt=null;v.depth&&(wt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,vt=v.stencil?Ts:ys,Rt=v.stencil?mr:Ui);let qt={colorFormat:e.RGBA8,depthFormat:wt,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(qt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),M=new di(f.textureWidth,f.textureHeight,{format:Bi,type:si,depthTexture:new Ms(f.textureWidth,f.textureHeight,Rt,void 0,void 0,void 0,void 0,void 0,void 0,vt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let vt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,vt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),M=new di(d.framebufferWidth,d.framebufferHeight,{format:Bi,type:si,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ct(et){for(let _t=0;_t<et.removed.length;_t++){let vt=et.removed[_t],Rt=E.indexOf(vt);Rt>=0&&(E[Rt]=null,P[Rt].disconnect(vt))}for(let _t=0;_t<et.added.length;_t++){let vt=et.added[_t],Rt=E.indexOf(vt);if(Rt===-1){for(let qt=0;qt<P.length;qt++)if(qt>=E.length){E.push(vt),Rt=qt;break}else if(E[qt]===null){E[qt]=vt,Rt=qt;break}if(Rt===-1)break}let wt=P[Rt];wt&&wt.connect(vt)}}function J(et,_t){_t===null?et.matrixWorld.copy(et.matrix):et.matrixWorld.multiplyMatrices(_t.matrixWorld,et.matrix),et.matrixWorldInverse.copy(et.matrixWorld).invert()}this.updateCamera=function(et){if(s===null)return;let _t=et.near,vt=et.far;p.texture!==null&&(p.depthNear>0&&(_t=p.depthNear),p.depthFar>0&&(vt=p.depthFar)),G.near=C.near=U.near=_t,G.far=C.far=U.far=vt,(D!==G.near||V!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),D=G.near,V=G.far),G.layers.mask=et.layers.mask|6,U.layers.mask=G.layers.mask&-5,C.layers.mask=G.layers.mask&-3;let Rt=et.parent,wt=G.cameras;J(G,Rt);for(let qt=0;qt<wt.length;qt++)J(wt[qt],Rt);G.projectionMatrix.copy(U.projectionMatrix),G.projectionMatrixInverse.copy(U.projectionMatrixInverse),k===null&&et.isPerspectiveCamera&&(k={camera:et,fov:et.fov,zoom:et.zoom}),Q(et,G,Rt)};function Q(et,_t,vt){vt===null?et.matrix.copy(_t.matrixWorld):(et.matrix.copy(vt.matrixWorld),et.matrix.invert(),et.matrix.multiply(_t.matrixWorld)),et.matrix.decompose(et.position,et.quaternion,et.scale),et.updateMatrixWorld(!0),et.projectionMatrix.copy(_t.projectionMatrix),et.projectionMatrixInverse.copy(_t.projectionMatrixInverse),et.isPerspectiveCamera&&(et.fov=lo*2*Math.atan(1/et.projectionMatrix.elements[5]),et.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(et){l=et,f!==null&&(f.fixedFoveation=et),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=et)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(G)},this.getCameraTexture=function(et){return g[et]};let rt=null;function dt(et,_t){if(h=_t.getViewerPose(c||o),m=_t,h!==null){let vt=h.views;d!==null&&(t.setRenderTargetFramebuffer(M,d.framebuffer),t.setRenderTarget(M));let Rt=!1;vt.length!==G.cameras.length&&(G.cameras.length=0,Rt=!0);for(let Wt=0;Wt<vt.length;Wt++){let me=vt[Wt],fe=null;if(d!==null)fe=d.getViewport(me);else{let Je=u.getViewSubImage(f,me);fe=Je.viewport,Wt===0&&(t.setRenderTargetTextures(M,Je.colorTexture,Je.depthStencilTexture),t.setRenderTarget(M))}let oe=F[Wt];oe===void 0&&(oe=new Jn,oe.layers.enable(Wt),oe.viewport=new je,F[Wt]=oe),oe.matrix.fromArray(me.transform.matrix),oe.matrix.decompose(oe.position,oe.quaternion,oe.scale),oe.projectionMatrix.fromArray(me.projectionMatrix),oe.projectionMatrixInverse.copy(oe.projectionMatrix).invert(),oe.viewport.set(fe.x,fe.y,fe.width,fe.height),Wt===0&&(G.matrix.copy(oe.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Rt===!0&&G.cameras.push(oe)}let wt=s.enabledFeatures;if(wt&&wt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Wt=u.getDepthInformation(vt[0]);Wt&&Wt.isValid&&Wt.texture&&p.init(Wt,s.renderState)}if(wt&&wt.includes("camera-access")&&y){t.state.unbindTexture(),u=n.getBinding();for(let Wt=0;Wt<vt.length;Wt++){let me=vt[Wt].camera;if(me){let fe=g[me];fe||(fe=new xa,g[me]=fe);let oe=u.getCameraImage(me);fe.sourceTexture=oe}}}}for(let vt=0;vt<P.length;vt++){let Rt=E[vt],wt=P[vt];Rt!==null&&wt!==void 0&&wt.update(Rt,_t,c||o)}rt&&rt(et,_t),_t.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:_t}),m=null}let ft=new jm;ft.setAnimationLoop(dt),this.setAnimationLoop=function(et){rt=et},this.dispose=function(){}}},aw=new ke,lg=new re;lg.set(-1,0,0,0,1,0,0,0,1);function lw(i,t){function e(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function n(p,g){g.color.getRGB(p.fogColor.value,ff(i)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,v,A,M){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),u(p,g)):g.isMeshPhongMaterial?(r(p,g),h(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),f(p,g),g.isMeshPhysicalMaterial&&d(p,g,M)):g.isMeshMatcapMaterial?(r(p,g),m(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),y(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?l(p,g,v,A):g.isSpriteMaterial?c(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,e(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===ti&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,e(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===ti&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,e(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,e(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let v=t.get(g),A=v.envMap,M=v.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.value.setFromMatrix4(aw.makeRotationFromEuler(M)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(lg),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function l(p,g,v,A){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*v,p.scale.value=A*.5,g.map&&(p.map.value=g.map,e(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function c(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function h(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function u(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function f(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function d(p,g,v){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ti&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,p.specularIntensityMapTransform))}function m(p,g){g.matcap&&(p.matcap.value=g.matcap)}function y(p,g){let v=t.get(g).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function cw(i,t,e,n){let s={},r={};function o(v,A){let M=A.program;n.uniformBlockBinding(v,M,s[v.id])}function a(v,A){let M=s[v.id];M===void 0&&(m(v),M=l(v),s[v.id]=M,v.addEventListener("dispose",p));let P=A.program;n.updateUBOMapping(v,P);let E=t.render.frame;r[v.id]!==E&&(c(v),r[v.id]=E)}function l(v){let A=i.createBuffer(),M=v.__size,P=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,M,P),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function c(v){let A=s[v.id],M=v.uniforms,P=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,_=M.length;E<_;E++){let T=M[E];if(Array.isArray(T))for(let k=0,U=T.length;k<U;k++)h(T[k],E,k,P);else h(T,E,0,P)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,A,M,P){if(f(v,A,M,P)===!0){let E=v.__offset,_=v.value;if(Array.isArray(_)){let T=0;for(let k=0;k<_.length;k++){let U=_[k],C=y(U,!0);u(U,v.__data,T),T+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,v.__data)}}function u(v,A,M){typeof v=="number"||typeof v=="boolean"?A[M]=v:v.isMatrix3?(A[M]=v.elements[0],A[M+1]=v.elements[1],A[M+2]=v.elements[2],A[M+3]=0,A[M+4]=v.elements[3],A[M+5]=v.elements[4],A[M+6]=v.elements[5],A[M+7]=0,A[M+8]=v.elements[6],A[M+9]=v.elements[7],A[M+10]=v.elements[8],A[M+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-M),M):v.toArray(A,M)}function f(v,A,M,P){let E=v.value,_=A+"_"+M;if(Array.isArray(E)){P[_]===void 0&&(P[_]=[]);let T=P[_],k=!1;for(let U=0;U<E.length;U++)d(E[U],T,U)===!0&&(k=!0);return k}return d(E,P,_)}function d(v,A,M){if(A[M]===void 0)return typeof v=="number"||typeof v=="boolean"?A[M]=v:ArrayBuffer.isView(v)?A[M]=v.slice():A[M]=v.clone(),!0;{let P=A[M];if(typeof v=="number"||typeof v=="boolean"){if(P!==v)return A[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(P.equals(v)===!1)return P.copy(v),!0}}return!1}function m(v){let A=v.uniforms,M=0,P=16;for(let _=0,T=A.length;_<T;_++){let k=Array.isArray(A[_])?A[_]:[A[_]];for(let U=0,C=k.length;U<C;U++){let F=k[U],G=Array.isArray(F.value)?F.value:[F.value],D=Array.isArray(A[_])||Array.isArray(F.value),V=M;for(let H=0,ct=G.length;H<ct;H++){let J=G[H],Q=y(J,D),rt=M%P,dt=rt%Q.boundary,ft=rt+dt;M+=dt,ft!==0&&P-ft<Q.storage&&(M+=P-ft),H===0&&(V=M),M+=Q.storage}let $=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new $((M-V)/Float32Array.BYTES_PER_ELEMENT),F.__offset=V}}let E=M%P;return E>0&&(M+=P-E),v.__size=M,v.__cache={},this}function y(v,A){let M={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):jt("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function p(v){let A=v.target;A.removeEventListener("dispose",p),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function g(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var hw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),is=null;function uw(){return is===null&&(is=new oc(hw,16,16,Js,Oi),is.name="DFG_LUT",is.minFilter=Kn,is.magFilter=Kn,is.wrapS=Ki,is.wrapT=Ki,is.generateMipmaps=!1,is.needsUpdate=!0),is}var mh=class{constructor(t={}){let{canvas:e=Mm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=si}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let y=d,p=new Set([Dc,Lc,Ic]),g=new Set([si,Ui,vo,mr,Rc,Pc]),v=new Uint32Array(4),A=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},P=null,E=null,_=[],T=[],k=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ns,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,C=!1,F=null,G=null,D=null,V=null;this._outputColorSpace=Zn;let $=0,H=0,ct=null,J=-1,Q=null,rt=new je,dt=new je,ft=null,et=new he(0),_t=0,vt=e.width,Rt=e.height,wt=1,qt=null,le=null,Wt=new je(0,0,vt,Rt),me=new je(0,0,vt,Rt),fe=!1,oe=new Hs,Je=new ac,He=!1,un=!1,Oe=new ke,An=new X,be=new je,yn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function fn(){return ct===null?wt:1}let B=n;function It(w,z){return e.getContext(w,z)}let Qt,ce,Tt,ze,Ht,Kt,I,S,q,ut,at,yt,St,nt,st,gt,O,ot,it,Et,xt,bt,Xt;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",zt,!1),e.addEventListener("webglcontextrestored",ne,!1),e.addEventListener("webglcontextcreationerror",Pt,!1),B===null){let z="webgl2";if(B=It(z,w),B===null)throw It(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ee()}catch(w){throw e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Pt,!1),ie("WebGLRenderer: "+w.message),w}function ee(){Qt=new MM(B),Qt.init(),xt=new sw(B,Qt),ce=new uM(B,Qt,t,xt),Tt=new nw(B,Qt),ce.reversedDepthBuffer&&f&&Tt.buffers.depth.setReversed(!0),G=B.createFramebuffer(),D=B.createFramebuffer(),V=B.createFramebuffer(),ze=new TM(B),Ht=new Gb,Kt=new iw(B,Qt,Tt,Ht,ce,xt,ze),I=new SM(U),S=new Ay(B),bt=new cM(B,S),q=new bM(B,S,ze,bt),ut=new AM(B,q,S,bt,ze),ot=new EM(B,ce,Kt),st=new fM(Ht),at=new Vb(U,I,Qt,ce,bt,st),yt=new lw(U,Ht),St=new Wb,nt=new Jb(Qt),O=new lM(U,I,Tt,ut,m,l),gt=new ew(U,ut,ce),Xt=new cw(B,ze,ce,Tt),it=new hM(B,Qt,ze),Et=new wM(B,Qt,ze),ze.programs=at.programs,U.capabilities=ce,U.extensions=Qt,U.properties=Ht,U.renderLists=St,U.shadowMap=gt,U.state=Tt,U.info=ze}y!==si&&(k=new RM(y,e.width,e.height,a,s,r));let ht=new Tf(U,B);this.xr=ht,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let w=Qt.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=Qt.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return wt},this.setPixelRatio=function(w){w!==void 0&&(wt=w,this.setSize(vt,Rt,!1))},this.getSize=function(w){return w.set(vt,Rt)},this.setSize=function(w,z,tt=!0){if(ht.isPresenting){jt("WebGLRenderer: Can't change size while VR device is presenting.");return}vt=w,Rt=z,e.width=Math.floor(w*wt),e.height=Math.floor(z*wt),tt===!0&&(e.style.width=w+"px",e.style.height=z+"px"),k!==null&&k.setSize(e.width,e.height),this.setViewport(0,0,w,z)},this.getDrawingBufferSize=function(w){return w.set(vt*wt,Rt*wt).floor()},this.setDrawingBufferSize=function(w,z,tt){vt=w,Rt=z,wt=tt,e.width=Math.floor(w*tt),e.height=Math.floor(z*tt),this.setViewport(0,0,w,z)},this.setEffects=function(w){if(y===si){ie("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let z=0;z<w.length;z++)if(w[z].isOutputPass===!0){jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(rt)},this.getViewport=function(w){return w.copy(Wt)},this.setViewport=function(w,z,tt,Y){w.isVector4?Wt.set(w.x,w.y,w.z,w.w):Wt.set(w,z,tt,Y),Tt.viewport(rt.copy(Wt).multiplyScalar(fn()).round())},this.getScissor=function(w){return w.copy(me)},this.setScissor=function(w,z,tt,Y){w.isVector4?me.set(w.x,w.y,w.z,w.w):me.set(w,z,tt,Y),Tt.scissor(dt.copy(me).multiplyScalar(fn()).round())},this.getScissorTest=function(){return fe},this.setScissorTest=function(w){Tt.setScissorTest(fe=w)},this.setOpaqueSort=function(w){qt=w},this.setTransparentSort=function(w){le=w},this.getClearColor=function(w){return w.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(w=!0,z=!0,tt=!0){let Y=0;if(w){let Z=!1;if(ct!==null){let At=ct.texture.format;Z=p.has(At)}if(Z){let At=ct.texture.type,Lt=g.has(At),Ct=O.getClearColor(),Dt=O.getClearAlpha(),Gt=Ct.r,se=Ct.g,ge=Ct.b;Lt?(v[0]=Gt,v[1]=se,v[2]=ge,v[3]=Dt,B.clearBufferuiv(B.COLOR,0,v)):(A[0]=Gt,A[1]=se,A[2]=ge,A[3]=Dt,B.clearBufferiv(B.COLOR,0,A))}else Y|=B.COLOR_BUFFER_BIT}z&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),tt&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),F=w},this.dispose=function(){e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Pt,!1),O.dispose(),St.dispose(),nt.dispose(),Kt.dispose(),Ht.dispose(),I.dispose(),ut.dispose(),q.dispose(),bt.dispose(),Xt.dispose(),at.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",Ka),ht.removeEventListener("sessionend",Gi),as.stop()};function zt(w){w.preventDefault(),aa("WebGLRenderer: Context Lost."),C=!0}function ne(){aa("WebGLRenderer: Context Restored."),C=!1;let w=ze.autoReset,z=gt.enabled,tt=gt.autoUpdate,Y=gt.needsUpdate,Z=gt.type;ee(),ze.autoReset=w,gt.enabled=z,gt.autoUpdate=tt,gt.needsUpdate=Y,gt.type=Z}function Pt(w){ie("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function ue(w){let z=w.target;z.removeEventListener("dispose",ue),We(z)}function We(w){Hn(w),Ht.remove(w)}function Hn(w){let z=Ht.get(w).programs;z!==void 0&&(z.forEach(function(tt){at.releaseProgram(tt)}),w.isShaderMaterial&&at.releaseShaderCache(w))}this.renderBufferDirect=function(w,z,tt,Y,Z,At){z===null&&(z=yn);let Lt=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ct=Bo(w,z,tt,Y,Z);Tt.setMaterial(Y,Lt);let Dt=tt.index,Gt=1;if(Y.wireframe===!0){if(Dt=q.getWireframeAttribute(tt),Dt===void 0)return;Gt=2}let se=tt.drawRange,ge=tt.attributes.position,Vt=se.start*Gt,_e=(se.start+se.count)*Gt;At!==null&&(Vt=Math.max(Vt,At.start*Gt),_e=Math.min(_e,(At.start+At.count)*Gt)),Dt!==null?(Vt=Math.max(Vt,0),_e=Math.min(_e,Dt.count)):ge!=null&&(Vt=Math.max(Vt,0),_e=Math.min(_e,ge.count));let Qe=_e-Vt;if(Qe<0||Qe===1/0)return;bt.setup(Z,Y,Ct,tt,Dt);let De,Ne=it;if(Dt!==null&&(De=S.get(Dt),Ne=Et,Ne.setIndex(De)),Z.isMesh)Y.wireframe===!0?(Tt.setLineWidth(Y.wireframeLinewidth*fn()),Ne.setMode(B.LINES)):Ne.setMode(B.TRIANGLES);else if(Z.isLine){let vn=Y.linewidth;vn===void 0&&(vn=1),Tt.setLineWidth(vn*fn()),Z.isLineSegments?Ne.setMode(B.LINES):Z.isLineLoop?Ne.setMode(B.LINE_LOOP):Ne.setMode(B.LINE_STRIP)}else Z.isPoints?Ne.setMode(B.POINTS):Z.isSprite&&Ne.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(Qt.get("WEBGL_multi_draw"))Ne.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let vn=Z._multiDrawStarts,Bt=Z._multiDrawCounts,dn=Z._multiDrawCount,ve=Dt?S.get(Dt).bytesPerElement:1,cs=Ht.get(Y).currentProgram.getUniforms();for(let pn=0;pn<dn;pn++)cs.setValue(B,"_gl_DrawID",pn),Ne.render(vn[pn]/ve,Bt[pn])}else if(Z.isInstancedMesh)Ne.renderInstances(Vt,Qe,Z.count);else if(tt.isInstancedBufferGeometry){let vn=tt._maxInstanceCount!==void 0?tt._maxInstanceCount:1/0,Bt=Math.min(tt.instanceCount,vn);Ne.renderInstances(Vt,Qe,Bt)}else Ne.render(Vt,Qe)};function Uo(w,z,tt,Y){F!==null&&w.isNodeMaterial&&F.setObject(Y,w),He===!0&&st.setState(w,tt,!1),w.transparent===!0&&w.side===ii&&w.forceSinglePass===!1?(w.side=ti,w.needsUpdate=!0,Hi(w,z,Y),w.side=Zs,w.needsUpdate=!0,Hi(w,z,Y),w.side=ii):Hi(w,z,Y)}this.compile=function(w,z,tt=null){tt===null&&(tt=w),F!==null&&F.renderStart(w,z,tt),E=nt.get(tt),E.init(z),T.push(E),tt.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),w!==tt&&w.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),E.setupLights(),F!==null&&F.updateLights(E.state.lightsArray),un=this.localClippingEnabled,He=st.init(this.clippingPlanes,un),He===!0&&st.setGlobalState(this.clippingPlanes,z),F!==null&&gt.render(E.state.shadowsArray,tt,z);let Y=new Set;return w.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let At=Z.material;if(At)if(Array.isArray(At))for(let Lt=0;Lt<At.length;Lt++){let Ct=At[Lt];Uo(Ct,tt,z,Z),Y.add(Ct)}else Uo(At,tt,z,Z),Y.add(At)}),E=T.pop(),F!==null&&F.renderEnd(),Y},this.compileAsync=function(w,z,tt=null){let Y=this.compile(w,z,tt);return new Promise(Z=>{function At(){if(Y.forEach(function(Lt){let Dt=Ht.get(Lt).currentProgram;(Dt===void 0||Dt.isReady())&&Y.delete(Lt)}),Y.size===0){Z(w);return}setTimeout(At,10)}Qt.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let Tr=null;function Wh(w){Tr&&Tr(w)}function Ka(){as.stop()}function Gi(){as.start()}let as=new jm;as.setAnimationLoop(Wh),typeof self<"u"&&as.setContext(self),this.setAnimationLoop=function(w){Tr=w,ht.setAnimationLoop(w),w===null?as.stop():as.start()},ht.addEventListener("sessionstart",Ka),ht.addEventListener("sessionend",Gi),this.render=function(w,z){if(z!==void 0&&z.isCamera!==!0){ie("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;F!==null&&F.renderStart(w,z);let tt=ht.enabled===!0&&ht.isPresenting===!0,Y=k!==null&&(ct===null||tt)&&k.begin(U,ct);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(z),z=ht.getCamera()),w.isScene===!0&&w.onBeforeRender(U,w,z,ct),E=nt.get(w,T.length),E.init(z),E.state.textureUnits=Kt.getTextureUnits(),T.push(E),Oe.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Je.setFromArrayCamera(z):oe.setFromProjectionMatrix(Oe,Mi,z.reversedDepth),un=this.localClippingEnabled,He=st.init(this.clippingPlanes,un),P=St.get(w,_.length),P.init(),_.push(P),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Lt=U.xr.getDepthSensingMesh();Lt!==null&&ls(Lt,z,-1/0,U.sortObjects)}ls(w,z,0,U.sortObjects),P.finish(),F!==null&&F.updateLights(E.state.lightsArray),U.sortObjects===!0&&P.sort(qt,le),en=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,en&&O.addToRenderList(P,w),this.info.autoReset===!0&&this.info.reset(),He===!0&&st.beginShadows();let Z=E.state.shadowsArray;if(gt.render(Z,w,z),He===!0&&st.endShadows(),(Y&&k.hasRenderPass())===!1){let Lt=P.opaque,Ct=P.transmissive;if(E.setupLights(),z.isArrayCamera){let Dt=z.cameras;if(Ct.length>0)for(let Gt=0,se=Dt.length;Gt<se;Gt++){let ge=Dt[Gt];Ei(Lt,Ct,w,ge)}en&&O.render(w);for(let Gt=0,se=Dt.length;Gt<se;Gt++){let ge=Dt[Gt];Fo(P,w,ge,ge.viewport)}}else Ct.length>0&&Ei(Lt,Ct,w,z),en&&O.render(w),Fo(P,w,z)}ct!==null&&H===0&&(Kt.updateMultisampleRenderTarget(ct),Kt.updateRenderTargetMipmap(ct)),Y&&k.end(U),w.isScene===!0&&w.onAfterRender(U,w,z),bt.resetDefaultState(),J=-1,Q=null,T.pop(),T.length>0?(E=T[T.length-1],Kt.setTextureUnits(E.state.textureUnits),He===!0&&st.setGlobalState(U.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?P=_[_.length-1]:P=null,F!==null&&F.renderEnd()};function ls(w,z,tt,Y){if(w.visible===!1)return;if(w.layers.test(z.layers)){if(w.isGroup)tt=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(z);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let Lt=z.isArrayCamera?Je:oe;if(!w.frustumCulled||w.intersectsFrustum(Lt)){Y&&be.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Oe);let Ct=ut.update(w),Dt=w.material;Dt.visible&&P.push(w,Ct,Dt,tt,be.z,null,z)}}else if(w.isMesh||w.isLine||w.isPoints){let Lt=z.isArrayCamera?Je:oe;if(!w.frustumCulled||w.intersectsFrustum(Lt)){let Ct=ut.update(w),Dt=w.material;if(Y&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),be.copy(w.boundingSphere.center)):(Ct.boundingSphere===null&&Ct.computeBoundingSphere(),be.copy(Ct.boundingSphere.center)),be.applyMatrix4(w.matrixWorld).applyMatrix4(Oe)),Array.isArray(Dt)){let Gt=Ct.groups;for(let se=0,ge=Gt.length;se<ge;se++){let Vt=Gt[se],_e=Dt[Vt.materialIndex];_e&&_e.visible&&P.push(w,Ct,_e,tt,be.z,Vt,z)}}else Dt.visible&&P.push(w,Ct,Dt,tt,be.z,null,z)}}}let At=w.children;for(let Lt=0,Ct=At.length;Lt<Ct;Lt++)ls(At[Lt],z,tt,Y)}function Fo(w,z,tt,Y){let{opaque:Z,transmissive:At,transparent:Lt}=w;E.setupLightsView(tt),He===!0&&st.setGlobalState(U.clippingPlanes,tt),Y&&Tt.viewport(rt.copy(Y)),Z.length>0&&nn(Z,z,tt),At.length>0&&nn(At,z,tt),Lt.length>0&&nn(Lt,z,tt),Tt.buffers.depth.setTest(!0),Tt.buffers.depth.setMask(!0),Tt.buffers.color.setMask(!0),Tt.setPolygonOffset(!1)}function Ei(w,z,tt,Y){if((tt.isScene===!0?tt.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Y.id]===void 0){let Vt=Qt.has("EXT_color_buffer_half_float")||Qt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Y.id]=new di(1,1,{generateMipmaps:!0,type:Vt?Oi:si,minFilter:ws,samples:Math.max(4,ce.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Se.workingColorSpace})}let At=E.state.transmissionRenderTarget[Y.id],Lt=Y.viewport||rt;At.setSize(Lt.z*U.transmissionResolutionScale,Lt.w*U.transmissionResolutionScale);let Ct=U.getRenderTarget(),Dt=U.getActiveCubeFace(),Gt=U.getActiveMipmapLevel();U.setRenderTarget(At),U.getClearColor(et),_t=U.getClearAlpha(),_t<1&&U.setClearColor(16777215,.5),U.clear(),en&&O.render(tt);let se=U.toneMapping;U.toneMapping=ns;let ge=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),E.setupLightsView(Y),He===!0&&st.setGlobalState(U.clippingPlanes,Y),nn(w,tt,Y),Kt.updateMultisampleRenderTarget(At),Kt.updateRenderTargetMipmap(At),Qt.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let _e=0,Qe=z.length;_e<Qe;_e++){let De=z[_e],{object:Ne,geometry:vn,material:Bt,group:dn}=De;if(Bt.side===ii&&Ne.layers.test(Y.layers)){let ve=Bt.side;Bt.side=ti,Bt.needsUpdate=!0,ln(Ne,tt,Y,vn,Bt,dn),Bt.side=ve,Bt.needsUpdate=!0,Vt=!0}}Vt===!0&&(Kt.updateMultisampleRenderTarget(At),Kt.updateRenderTargetMipmap(At))}U.setRenderTarget(Ct,Dt,Gt),U.setClearColor(et,_t),ge!==void 0&&(Y.viewport=ge),U.toneMapping=se}function nn(w,z,tt){let Y=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,At=w.length;Z<At;Z++){let Lt=w[Z],{object:Ct,geometry:Dt,group:Gt}=Lt,se=Lt.material;se.allowOverride===!0&&Y!==null&&(se=Y),Ct.layers.test(tt.layers)&&ln(Ct,z,tt,Dt,se,Gt)}}function ln(w,z,tt,Y,Z,At){F!==null&&Z.isNodeMaterial&&F.setObject(w,Z),w.onBeforeRender(U,z,tt,Y,Z,At),w.modelViewMatrix.multiplyMatrices(tt.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Z.onBeforeRender(U,z,tt,Y,w,At),Z.transparent===!0&&Z.side===ii&&Z.forceSinglePass===!1?(Z.side=ti,Z.needsUpdate=!0,U.renderBufferDirect(tt,z,Y,Z,w,At),Z.side=Zs,Z.needsUpdate=!0,U.renderBufferDirect(tt,z,Y,Z,w,At),Z.side=ii):U.renderBufferDirect(tt,z,Y,Z,w,At),w.onAfterRender(U,z,tt,Y,Z,At)}function cn(w){let z=0;for(let tt of w)tt.texture!==null&&z++;return z}function Hi(w,z,tt){z.isScene!==!0&&(z=yn);let Y=Ht.get(w),Z=E.state.lights,At=E.state.shadowsArray,Lt=Z.state.version,Ct=at.getParameters(w,Z.state,At,z,tt,E.state.lightProbeGridArray),Dt=at.getProgramCacheKey(Ct),Gt=Y.programs;Y.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?z.environment:null,Y.fog=z.fog;let se=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;Y.envMap=I.get(w.envMap||Y.environment,se),Y.envMapRotation=Y.environment!==null&&w.envMap===null?z.environmentRotation:w.envMapRotation,Gt===void 0&&(w.addEventListener("dispose",ue),Gt=new Map,Y.programs=Gt,Y.programVariants=new Map);let ge=Gt.get(Dt);if(ge!==void 0){if(Y.currentProgram===ge&&Y.lightsStateVersion===Lt)return Oo(w,Ct),ge}else Ct.uniforms=at.getUniforms(w),F!==null&&w.isNodeMaterial&&F.build(w,tt,Ct),w.onBeforeCompile(Ct,U),ge=at.acquireProgram(Ct,Dt),Gt.set(Dt,ge),Y.uniforms=Ct.uniforms;let Vt=Y.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Vt.clippingPlanes=st.uniform),Oo(w,Ct),Y.needsLights=Ls(w),Y.lightsStateVersion=Lt,Y.needsLights&&(Vt.ambientLightColor.value=Z.state.ambient,Vt.lightProbe.value=Z.state.probe,Vt.sunLights.value=Z.state.sun,Vt.sunLightShadows.value=Z.state.sunShadow,Vt.directionalLights.value=Z.state.directional,Vt.directionalLightShadows.value=Z.state.directionalShadow,Vt.spotLights.value=Z.state.spot,Vt.spotLightShadows.value=Z.state.spotShadow,Vt.rectAreaLights.value=Z.state.rectArea,Vt.ltc_1.value=Z.state.rectAreaLTC1,Vt.ltc_2.value=Z.state.rectAreaLTC2,Vt.pointLights.value=Z.state.point,Vt.pointLightShadows.value=Z.state.pointShadow,Vt.hemisphereLights.value=Z.state.hemi,Vt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Vt.sunShadowCascade.value=Z.state.sunShadowCascade,Vt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Vt.spotLightMatrix.value=Z.state.spotLightMatrix,Vt.spotLightMap.value=Z.state.spotLightMap,Vt.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=cn(E.state.lightProbeGridArray),Y.currentProgram=ge,Y.uniformsList=null,ge}function oi(w,z,tt,Y,Z){let At=Ht.get(w),Lt=At.currentProgram.id+","+Y+","+Z,Ct=At.programVariants.get(Lt);return Ct===void 0?(Ct=Hi(w,z,tt),At.programVariants.set(Lt,Ct)):(At.currentProgram=Ct,At.uniformsList=null,At.outputColorSpace=Y,At.toneMapping=Z),Ct}function Is(w){if(w.uniformsList===null){let z=w.currentProgram.getUniforms();w.uniformsList=So.seqWithValue(z.seq,w.uniforms)}return w.uniformsList}function Oo(w,z){let tt=Ht.get(w);tt.outputColorSpace=z.outputColorSpace,tt.batching=z.batching,tt.batchingColor=z.batchingColor,tt.instancing=z.instancing,tt.instancingColor=z.instancingColor,tt.instancingMorph=z.instancingMorph,tt.skinning=z.skinning,tt.morphTargets=z.morphTargets,tt.morphNormals=z.morphNormals,tt.morphColors=z.morphColors,tt.morphTargetsCount=z.morphTargetsCount,tt.numClippingPlanes=z.numClippingPlanes,tt.numIntersection=z.numClipIntersection,tt.vertexAlphas=z.vertexAlphas,tt.vertexTangents=z.vertexTangents,tt.toneMapping=z.toneMapping}function Bo(w,z,tt,Y,Z){z.isScene!==!0&&(z=yn),Kt.resetTextureUnits();let At=z.fog,Lt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?z.environment:null,Ct=ct===null?U.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:Se.workingColorSpace,Dt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Gt=I.get(Y.envMap||Lt,Dt),se=Y.vertexColors===!0&&!!tt.attributes.color&&tt.attributes.color.itemSize===4,ge=!!tt.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Vt=!!tt.morphAttributes.position,_e=!!tt.morphAttributes.normal,Qe=!!tt.morphAttributes.color,De=ns;Y.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(De=U.toneMapping);let Ne=tt.morphAttributes.position||tt.morphAttributes.normal||tt.morphAttributes.color,vn=Ne!==void 0?Ne.length:0,Bt=Ht.get(Y),dn=E.state.lights;if(He===!0&&(un===!0||w!==Q)){let Ue=w===Q&&Y.id===J;st.setState(Y,w,Ue)}let ve=!1,cs=!1;Y.version===Bt.__version?Bt.needsLights&&Bt.lightsStateVersion!==dn.state.version||Z.isBatchedMesh&&Bt.batching===!1||!Z.isBatchedMesh&&Bt.batching===!0||Z.isBatchedMesh&&Bt.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Bt.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Bt.instancing===!1||!Z.isInstancedMesh&&Bt.instancing===!0||Z.isSkinnedMesh&&Bt.skinning===!1||!Z.isSkinnedMesh&&Bt.skinning===!0||Z.isInstancedMesh&&Bt.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Bt.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Bt.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Bt.instancingMorph===!1&&Z.morphTexture!==null||Bt.envMap!==Gt||Y.fog===!0&&Bt.fog!==At||Bt.numClippingPlanes!==void 0&&(Bt.numClippingPlanes!==st.numPlanes||Bt.numIntersection!==st.numIntersection)||Bt.vertexAlphas!==se||Bt.vertexTangents!==ge||Bt.morphTargets!==Vt||Bt.morphNormals!==_e||Bt.morphColors!==Qe||Bt.morphTargetsCount!==vn||Bt.numLightProbeGrids!==cn(E.state.lightProbeGridArray)?ve=!0:(Bt.outputColorSpace!==Ct||Bt.toneMapping!==De)&&(cs=!0):(ve=!0,Bt.__version=Y.version);let pn=Bt.currentProgram;(ve===!0||cs===!0)&&(pn=cs===!0?oi(Y,z,Z,Ct,De):Hi(Y,z,Z),F&&Y.isNodeMaterial&&F.onUpdateProgram(Y,pn,Bt));let Cr=!1,Wi=!1,hs=!1,de=pn.getUniforms(),sn=Bt.uniforms;if(Tt.useProgram(pn.program)&&(Cr=!0,Wi=!0,hs=!0),Y.id!==J&&(J=Y.id,Wi=!0),Cr||Q!==w){Tt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),de.setValue(B,"projectionMatrix",w.projectionMatrix),de.setValue(B,"viewMatrix",w.matrixWorldInverse);let mn=de.map.cameraPosition;mn!==void 0&&mn.setValue(B,An.setFromMatrixPosition(w.matrixWorld)),ce.logarithmicDepthBuffer&&de.setValue(B,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&de.setValue(B,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,Wi=!0,hs=!0)}if(Bt.needsLights&&(dn.state.sunShadowMap.length>0&&de.setValue(B,"sunShadowMap",dn.state.sunShadowMap,Kt),dn.state.directionalShadowMap.length>0&&de.setValue(B,"directionalShadowMap",dn.state.directionalShadowMap,Kt),dn.state.spotShadowMap.length>0&&de.setValue(B,"spotShadowMap",dn.state.spotShadowMap,Kt),dn.state.pointShadowMap.length>0&&de.setValue(B,"pointShadowMap",dn.state.pointShadowMap,Kt)),Z.isSkinnedMesh){de.setOptional(B,Z,"bindMatrix"),de.setOptional(B,Z,"bindMatrixInverse");let Ue=Z.skeleton;Ue&&(Ue.boneTexture===null&&Ue.computeBoneTexture(),de.setValue(B,"boneTexture",Ue.boneTexture,Kt))}Z.isBatchedMesh&&(de.setOptional(B,Z,"batchingTexture"),de.setValue(B,"batchingTexture",Z._matricesTexture,Kt),de.setOptional(B,Z,"batchingIdTexture"),de.setValue(B,"batchingIdTexture",Z._indirectTexture,Kt),de.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&de.setValue(B,"batchingColorTexture",Z._colorsTexture,Kt));let Wn=tt.morphAttributes;if((Wn.position!==void 0||Wn.normal!==void 0||Wn.color!==void 0)&&ot.update(Z,tt,pn),(Wi||Bt.receiveShadow!==Z.receiveShadow)&&(Bt.receiveShadow=Z.receiveShadow,de.setValue(B,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&z.environment!==null&&(sn.envMapIntensity.value=z.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=uw()),Wi){if(de.setValue(B,"toneMappingExposure",U.toneMappingExposure),Bt.needsLights&&Er(sn,hs),At&&Y.fog===!0&&yt.refreshFogUniforms(sn,At),yt.refreshMaterialUniforms(sn,Y,wt,Rt,E.state.transmissionRenderTarget[w.id]),Bt.needsLights&&Bt.numLightProbeGrids>0){let Ue=M,mn=0;for(let kn of E.state.lightProbeGridArray)kn.texture!==null&&(Ue.textures[mn]=kn.texture,Ue.min[mn]=kn.boundingBox.min,Ue.max[mn]=kn.boundingBox.max,Ue.resolution[mn]=kn.resolution,mn++);for(let kn in Ue)Ue[kn].length=mn;sn.probesSH.value=Ue.textures,sn.probesMin.value=Ue.min,sn.probesMax.value=Ue.max,sn.probesResolution.value=Ue.resolution}So.upload(B,Is(Bt),sn,Kt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(So.upload(B,Is(Bt),sn,Kt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&de.setValue(B,"center",Z.center),de.setValue(B,"modelViewMatrix",Z.modelViewMatrix),de.setValue(B,"normalMatrix",Z.normalMatrix),de.setValue(B,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Ue=Y.uniformsGroups;for(let mn=0,kn=Ue.length;mn<kn;mn++){let ja=Ue[mn];Xt.update(ja,pn),Xt.bind(ja,pn)}}return pn}function Er(w,z){w.ambientLightColor.needsUpdate=z,w.lightProbe.needsUpdate=z,w.sunLights.needsUpdate=z,w.sunLightShadows.needsUpdate=z,w.directionalLights.needsUpdate=z,w.directionalLightShadows.needsUpdate=z,w.pointLights.needsUpdate=z,w.pointLightShadows.needsUpdate=z,w.spotLights.needsUpdate=z,w.spotLightShadows.needsUpdate=z,w.rectAreaLights.needsUpdate=z,w.hemisphereLights.needsUpdate=z}function Ls(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(w,z,tt){let Y=Ht.get(w);Y.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ht.get(w.texture).__webglTexture=z,Ht.get(w.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:tt,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,z){let tt=Ht.get(w);tt.__webglFramebuffer=z,tt.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(w,z=0,tt=0){ct=w,$=z,H=tt;let Y=null,Z=!1,At=!1;if(w){let Ct=Ht.get(w);if(Ct.__useDefaultFramebuffer!==void 0){Tt.bindFramebuffer(B.FRAMEBUFFER,Ct.__webglFramebuffer),rt.copy(w.viewport),dt.copy(w.scissor),ft=w.scissorTest,Tt.viewport(rt),Tt.scissor(dt),Tt.setScissorTest(ft),J=-1;return}else if(Ct.__webglFramebuffer===void 0)Kt.setupRenderTarget(w);else if(Ct.__hasExternalTextures)Kt.rebindTextures(w,Ht.get(w.texture).__webglTexture,Ht.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let se=w.depthTexture;if(Ct.__boundDepthTexture!==se){if(se!==null&&Ht.has(se)&&(w.width!==se.image.width||w.height!==se.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(w)}}let Dt=w.texture;(Dt.isData3DTexture||Dt.isDataArrayTexture||Dt.isCompressedArrayTexture)&&(At=!0);let Gt=Ht.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Gt[z])?Y=Gt[z][tt]:Y=Gt[z],Z=!0):w.samples>0&&Kt.useMultisampledRTT(w)===!1?Y=Ht.get(w).__webglMultisampledFramebuffer:Array.isArray(Gt)?Y=Gt[tt]:Y=Gt,rt.copy(w.viewport),dt.copy(w.scissor),ft=w.scissorTest}else rt.copy(Wt).multiplyScalar(wt).floor(),dt.copy(me).multiplyScalar(wt).floor(),ft=fe;if(tt!==0&&(Y=G),Tt.bindFramebuffer(B.FRAMEBUFFER,Y)&&Tt.drawBuffers(w,Y),Tt.viewport(rt),Tt.scissor(dt),Tt.setScissorTest(ft),Z){let Ct=Ht.get(w.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ct.__webglTexture,tt)}else if(At){let Ct=z;for(let Dt=0;Dt<w.textures.length;Dt++){let Gt=Ht.get(w.textures[Dt]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Dt,Gt.__webglTexture,tt,Ct)}}else if(w!==null&&tt!==0){let Ct=Ht.get(w.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ct.__webglTexture,tt)}J=-1};function Ar(w){let z=Ht.get(w);return(z.__readFormat!==w.format||z.__readType!==w.type)&&(z.__readFormat=w.format,z.__readType=w.type,z.__formatReadable=ce.textureFormatReadable(w.format),z.__typeReadable=ce.textureTypeReadable(w.type)),z}this.readRenderTargetPixels=function(w,z,tt,Y,Z,At,Lt,Ct=0){if(!(w&&w.isWebGLRenderTarget)){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Dt=Ht.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt){Tt.bindFramebuffer(B.FRAMEBUFFER,Dt);try{let Gt=w.textures[Ct],se=Gt.format,ge=Gt.type;w.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ct);let Vt=Ar(Gt);if(Vt.__formatReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=w.width-Y&&tt>=0&&tt<=w.height-Z&&B.readPixels(z,tt,Y,Z,xt.convert(se),xt.convert(ge),At)}finally{let Gt=ct!==null?Ht.get(ct).__webglFramebuffer:null;Tt.bindFramebuffer(B.FRAMEBUFFER,Gt)}}},this.readRenderTargetPixelsAsync=async function(w,z,tt,Y,Z,At,Lt,Ct=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Dt=Ht.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt)if(z>=0&&z<=w.width-Y&&tt>=0&&tt<=w.height-Z){Tt.bindFramebuffer(B.FRAMEBUFFER,Dt);let Gt=w.textures[Ct],se=Gt.format,ge=Gt.type;w.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ct);let Vt=Ar(Gt);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _e=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,_e),B.bufferData(B.PIXEL_PACK_BUFFER,At.byteLength,B.STREAM_READ),B.readPixels(z,tt,Y,Z,xt.convert(se),xt.convert(ge),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Qe=ct!==null?Ht.get(ct).__webglFramebuffer:null;Tt.bindFramebuffer(B.FRAMEBUFFER,Qe);let De=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await wm(B,De,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,_e),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,At),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(_e),B.deleteSync(De),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,z=null,tt=0){let Y=Math.pow(2,-tt),Z=Math.floor(w.image.width*Y),At=Math.floor(w.image.height*Y),Lt=z!==null?z.x:0,Ct=z!==null?z.y:0;Kt.setTexture2D(w,0),B.copyTexSubImage2D(B.TEXTURE_2D,tt,0,0,Lt,Ct,Z,At),Tt.unbindTexture()},this.copyTextureToTexture=function(w,z,tt=null,Y=null,Z=0,At=0){let Lt,Ct,Dt,Gt,se,ge,Vt,_e,Qe,De=w.isCompressedTexture?w.mipmaps[At]:w.image;if(tt!==null)Lt=tt.max.x-tt.min.x,Ct=tt.max.y-tt.min.y,Dt=tt.isBox3?tt.max.z-tt.min.z:1,Gt=tt.min.x,se=tt.min.y,ge=tt.isBox3?tt.min.z:0;else{let de=Math.pow(2,-Z);Lt=Math.floor(De.width*de),Ct=Math.floor(De.height*de),w.isDataArrayTexture?Dt=De.depth:w.isData3DTexture?Dt=Math.floor(De.depth*de):Dt=1,Gt=0,se=0,ge=0}Y!==null?(Vt=Y.x,_e=Y.y,Qe=Y.z):(Vt=0,_e=0,Qe=0);let Ne=xt.convert(z.format),vn=xt.convert(z.type),Bt;z.isData3DTexture?(Kt.setTexture3D(z,0),Bt=B.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Kt.setTexture2DArray(z,0),Bt=B.TEXTURE_2D_ARRAY):(Kt.setTexture2D(z,0),Bt=B.TEXTURE_2D),Tt.activeTexture(B.TEXTURE0),Tt.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,z.flipY),Tt.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Tt.pixelStorei(B.UNPACK_ALIGNMENT,z.unpackAlignment);let dn=Tt.getParameter(B.UNPACK_ROW_LENGTH),ve=Tt.getParameter(B.UNPACK_IMAGE_HEIGHT),cs=Tt.getParameter(B.UNPACK_SKIP_PIXELS),pn=Tt.getParameter(B.UNPACK_SKIP_ROWS),Cr=Tt.getParameter(B.UNPACK_SKIP_IMAGES);Tt.pixelStorei(B.UNPACK_ROW_LENGTH,De.width),Tt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,De.height),Tt.pixelStorei(B.UNPACK_SKIP_PIXELS,Gt),Tt.pixelStorei(B.UNPACK_SKIP_ROWS,se),Tt.pixelStorei(B.UNPACK_SKIP_IMAGES,ge);let Wi=w.isDataArrayTexture||w.isData3DTexture,hs=z.isDataArrayTexture||z.isData3DTexture;if(w.isDepthTexture){let de=Ht.get(w),sn=Ht.get(z),Wn=Ht.get(de.__renderTarget),Ue=Ht.get(sn.__renderTarget);Tt.bindFramebuffer(B.READ_FRAMEBUFFER,Wn.__webglFramebuffer),Tt.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ue.__webglFramebuffer);for(let mn=0;mn<Dt;mn++)Wi&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ht.get(w).__webglTexture,Z,ge+mn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ht.get(z).__webglTexture,At,Qe+mn)),B.blitFramebuffer(Gt,se,Gt+Lt,se+Ct,Vt,_e,Vt+Lt,_e+Ct,B.DEPTH_BUFFER_BIT,B.NEAREST);Tt.bindFramebuffer(B.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||w.isRenderTargetTexture||Ht.has(w)){let de=Ht.get(w),sn=Ht.get(z);Tt.bindFramebuffer(B.READ_FRAMEBUFFER,D),Tt.bindFramebuffer(B.DRAW_FRAMEBUFFER,V);for(let Wn=0;Wn<Dt;Wn++)Wi?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,de.__webglTexture,Z,ge+Wn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,de.__webglTexture,Z),hs?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,sn.__webglTexture,At,Qe+Wn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,sn.__webglTexture,At),Z!==0?B.blitFramebuffer(Gt,se,Gt+Lt,se+Ct,Vt,_e,Vt+Lt,_e+Ct,B.COLOR_BUFFER_BIT,B.NEAREST):hs?B.copyTexSubImage3D(Bt,At,Vt,_e,Qe+Wn,Gt,se,Lt,Ct):B.copyTexSubImage2D(Bt,At,Vt,_e,Gt,se,Lt,Ct);Tt.bindFramebuffer(B.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else hs?w.isDataTexture||w.isData3DTexture?B.texSubImage3D(Bt,At,Vt,_e,Qe,Lt,Ct,Dt,Ne,vn,De.data):z.isCompressedArrayTexture?B.compressedTexSubImage3D(Bt,At,Vt,_e,Qe,Lt,Ct,Dt,Ne,De.data):B.texSubImage3D(Bt,At,Vt,_e,Qe,Lt,Ct,Dt,Ne,vn,De):w.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,At,Vt,_e,Lt,Ct,Ne,vn,De.data):w.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,At,Vt,_e,De.width,De.height,Ne,De.data):B.texSubImage2D(B.TEXTURE_2D,At,Vt,_e,Lt,Ct,Ne,vn,De);Tt.pixelStorei(B.UNPACK_ROW_LENGTH,dn),Tt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,ve),Tt.pixelStorei(B.UNPACK_SKIP_PIXELS,cs),Tt.pixelStorei(B.UNPACK_SKIP_ROWS,pn),Tt.pixelStorei(B.UNPACK_SKIP_IMAGES,Cr),At===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&B.generateMipmap(Bt),Tt.unbindTexture()},this.initRenderTarget=function(w){Ht.get(w).__webglFramebuffer===void 0&&Kt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Kt.setTextureCube(w,0):w.isData3DTexture?Kt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Kt.setTexture2DArray(w,0):Kt.setTexture2D(w,0),Tt.unbindTexture()},this.resetState=function(){$=0,H=0,ct=null,Tt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Se._getDrawingBufferColorSpace(t),e.unpackColorSpace=Se._getUnpackColorSpace()}};var cg=110,fw=new es({color:15311419,roughness:.55,metalness:.1}),Ef=new es({color:4411740,roughness:.5,metalness:.35}),hg=new es({color:11122626,roughness:.4,metalness:.5}),dw=new X(0,1,0),pw=i=>[...i.points,i.grip,i.approach,i.closing].flat(),xh=class{group=new On;grip=null;#e=null;#t=[];#n=[];#i=0;#s=80;goTo(t){let e=pw(t);this.#e||this.#a(t.points.length),this.#t=this.#n.length===e.length?this.#r():e,this.#n=e,this.#i=performance.now()}open(t){return t===void 0||t===this.#s?!1:(this.#s=t,!0)}step(){return this.#e?(this.#u(this.#r()),performance.now()-this.#i<cg):!1}#r(){let t=Math.min((performance.now()-this.#i)/cg,1);return this.#n.map((e,n)=>this.#t[n]+(e-this.#t[n])*t)}#o(t,e){let n=new Un(t,e);return this.group.add(n),n}#a(t){let e=o=>58-30*(o/Math.max(t-1,1)),n=[];for(let o=0;o+1<t;++o)n.push(this.#o(new bs(e(o+1)*.8,e(o)*.8,1,24),fw));let s=[];for(let o=0;o<t;++o)s.push(this.#o(new Ma(e(o),24,16),Ef));let r=()=>this.#o(new pi(9,24,52),hg);this.#e={links:n,joints:s,foot:this.#o(new bs(95,110,24,40),Ef),stem:this.#o(new bs(16,20,1,20),hg),palm:this.#o(new pi(1,34,18),Ef),fingers:[r(),r()]},this.#e.foot.rotation.x=Math.PI/2}#c(t,e,n){let s=n.clone().sub(e);t.visible=s.length()>1,t.position.copy(e).addScaledVector(s,.5),t.scale.set(1,Math.max(s.length(),1),1),t.quaternion.setFromUnitVectors(dw,s.normalize())}#u(t){let e=[];for(let m=0;m<t.length;m+=3)e.push(new X(t[m],t[m+1],t[m+2]));let[n,s,r]=e.splice(-3),{links:o,joints:a,foot:l,stem:c,palm:h,fingers:u}=this.#e;l.position.copy(e[0]).setZ(12),o.forEach((m,y)=>this.#c(m,e[y],e[y+1])),a.forEach((m,y)=>m.position.copy(e[y])),this.grip=n;let f=new jn().setFromRotationMatrix(new ke().makeBasis(r,new X().crossVectors(s,r),s)),d=n.clone().addScaledVector(s,-58);this.#c(c,e.at(-1),d),h.position.copy(d),h.quaternion.copy(f),h.scale.setX(this.#s+26),u.forEach((m,y)=>{m.position.copy(n).addScaledVector(s,-26).addScaledVector(r,(y?1:-1)*(this.#s/2+5)),m.quaternion.copy(f)})}};var ug={type:"change"},Cf={type:"start"},dg={type:"end"},yh=new ur,fg=new fi,mw=Math.cos(70*uf.DEG2RAD),wn=new X,ri=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Af=1e-6,vh=class extends Ia{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:$s.ROTATE,MIDDLE:$s.DOLLY,RIGHT:$s.PAN},this.touches={ONE:Ys.ROTATE,TWO:Ys.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new jn,this._lastTargetPosition=new X,this._quat=new jn().setFromUnitVectors(t.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new go,this._sphericalDelta=new go,this._scale=1,this._panOffset=new X,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new X,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=_w.bind(this),this._onPointerDown=gw.bind(this),this._onPointerUp=xw.bind(this),this._onContextMenu=Tw.bind(this),this._onMouseWheel=Sw.bind(this),this._onKeyDown=Mw.bind(this),this._onTouchStart=bw.bind(this),this._onTouchMove=ww.bind(this),this._onMouseDown=yw.bind(this),this._onMouseMove=vw.bind(this),this._interceptControlDown=Ew.bind(this),this._interceptControlUp=Aw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Re.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(ug),this.update(),this.state=Re.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;wn.copy(e).sub(this.target),wn.applyQuaternion(this._quat),this._spherical.setFromVector3(wn),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ri:n>Math.PI&&(n-=ri),s<-Math.PI?s+=ri:s>Math.PI&&(s-=ri),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(wn.setFromSpherical(this._spherical),wn.applyQuaternion(this._quatInverse),e.copy(this.target).add(wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=wn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new X(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new X(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(yh.origin.copy(this.object.position),yh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(yh.direction))<mw?this.object.lookAt(this.target):(fg.setFromNormalAndCoplanarPoint(this.object.up,this.target),yh.intersectPlane(fg,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Af||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Af||this._lastTargetPosition.distanceToSquared(this.target)>Af?(this.dispatchEvent(ug),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ri/60*this.autoRotateSpeed*t:ri/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){wn.setFromMatrixColumn(e,0),wn.multiplyScalar(-t),this._panOffset.add(wn)}_panUp(t,e){this.screenSpacePanning===!0?wn.setFromMatrixColumn(e,1):(wn.setFromMatrixColumn(e,0),wn.crossVectors(this.object.up,wn)),wn.multiplyScalar(t),this._panOffset.add(wn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;wn.copy(s).sub(this.target);let r=wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/e.clientHeight),this._rotateUp(ri*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/e.clientHeight),this._rotateUp(ri*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function gw(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function _w(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function xw(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(dg),this.state=Re.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function yw(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case $s.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Re.DOLLY;break;case $s.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}break;case $s.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(Cf)}function vw(i){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function Sw(i){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(i.preventDefault(),this.dispatchEvent(Cf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(dg))}function Mw(i){this.enabled!==!1&&this._handleKeyDown(i)}function bw(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Ys.ROTATE:if(this.enableRotate===!1){this.state=Re.NONE;break}this._handleTouchStartRotate(i),this.state=Re.TOUCH_ROTATE;break;case Ys.PAN:if(this.enablePan===!1){this.state=Re.NONE;break}this._handleTouchStartPan(i),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case Ys.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Re.TOUCH_DOLLY_PAN;break;case Ys.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(Cf)}function ww(i){switch(this._trackPointer(i),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Re.NONE}}function Tw(i){this.enabled!==!1&&i.preventDefault()}function Ew(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Aw(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Cw=80;function Rw(i){let t=i.getContext(),e=t.getExtension("WEBGL_debug_renderer_info"),n=t.getParameter(e?e.UNMASKED_RENDERER_WEBGL:t.RENDERER);return/swiftshader|llvmpipe|software/i.test(n)}var Rf=class{#e;constructor(t,e){this.canvas=e,this.renderer=t,this.pause=Rw(t)?Cw:0,this.#e=ni(()=>this.draw()),this.moving=()=>!1,this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.scene=new ha,this.scene.background=new he(923422),this.camera=new Jn(36,1,10,8e3),this.camera.up.set(0,0,1),this.camera.position.set(1500,-1010,770),this.controls=new vh(this.camera,e),this.controls.target.set(400,10,235),this.controls.maxDistance=4e3,this.controls.minDistance=200,this.controls.addEventListener("change",()=>this.ask()),this.controls.update(),this.light(),new ResizeObserver(()=>this.resize()).observe(e.parentElement)}light(){let t=new Ca(16777215,2.2);t.position.set(900,-700,1600);let e=new Pa(2e3,20,3493983,1911863);e.rotation.x=Math.PI/2,this.scene.add(new Ta(14674674,2569277,1.3),new Ra(16777215,.25),t,e)}resize(){let{clientWidth:t,clientHeight:e}=this.canvas.parentElement;!t||!e||(this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.ask())}ask(){this.#e()}says(t,e){this.canvas.dataset[t]=e}draw(){let t=this.moving();this.renderer.render(this.scene,this.camera),t&&(this.pause?setTimeout(()=>this.ask(),this.pause):this.ask())}};function pg(){let i=Ut("scene"),t;try{t=new mh({canvas:i,antialias:!0})}catch{return Ut("scene-note").hidden=!1,Ut("scene-note").textContent="This browser draws nothing in three dimensions (WebGL is off). All else works.",null}return new Rf(t,i)}var Pw=160,Sh="end-effector",Iw=50,Lw=2,Dw=.45,Nw=new X(0,1,0),Pf={circle:i=>i.arc(64,64,34,0,2*Math.PI),square:i=>i.rect(33,33,62,62),triangle:i=>mg(i,[[64,26],[102,96],[26,96]]),cross:i=>mg(i,[[52,26],[76,26],[76,52],[102,52],[102,76],[76,76],[76,102],[52,102],[52,76],[26,76],[26,52],[52,52]])};function mg(i,t){t.forEach(([e,n],s)=>s?i.lineTo(e,n):i.moveTo(e,n)),i.closePath()}function gg(i,t,e){let n=document.createElement("canvas");n.width=i,n.height=t,e(n.getContext("2d"));let s=new ga(n);return s.colorSpace=Zn,s}function Uw(i){return gg(128,128,t=>{let[e,n]=i===Sh?["#14181b","#f4f6f7"]:["#f4f6f7","#14181b"];t.fillStyle=e,t.fillRect(0,0,128,128),t.fillStyle=n,t.beginPath();let s=i===Sh?Pf.triangle:Object.hasOwn(Pf,i)?Pf[i]:null;s&&s(t),t.fill(),!s&&(t.font="bold 64px system-ui, sans-serif",t.textAlign="center",t.fillText(i.slice(0,1).toUpperCase(),64,86))})}function Fw(i){return gg(256,64,t=>{t.font="600 34px system-ui, sans-serif",t.textAlign="center",t.lineWidth=7,t.strokeStyle="#0e171e";let e=i.length>14?`${i.slice(0,13)}\u2026`:i;t.strokeText(e,128,44),t.fillStyle="#ffffff",t.fillText(e,128,44)})}var Mh=class{group=new On;#e;#t=null;#n=null;#i=0;#s;#r;#o;constructor(t,e){this.#e=e;let n=new es({color:15133420,roughness:.8}),s=new es({map:Uw(t),roughness:.8});s.map.center.set(.5,.5),s.map.rotation=Math.PI/2;let r=t===Sh?4:e,o=t===Sh?e*.7:e,a=new Un(new pi(r,o,o),[s,n,n,n,n,n]);a.position.setX(-r/2);let l=new pa(new uo({map:Fw(t),depthTest:!1}));l.scale.set(e*2.4,e*.6,1),l.position.set(-e/2,0,e*.85),this.#s=[n,s],this.#r=new Un(new bs(4,4,1,8),new Ss({color:7127295,depthTest:!1,transparent:!0})),this.#o=new Un(new Sa(e*.85,e*.97,40),new Ss({color:15901498,side:ii,transparent:!0})),this.#o.position.set(-r/2,0,-o/2+2),this.#r.visible=!1,this.#o.visible=!1,this.group.add(a,l,this.#r,this.#o)}believe(t,e){let n=t&&t.state!=="seen";for(let s of this.#s)s.opacity=n?Dw:1,s.transparent=!!n;this.#r.visible=!!(t?.spread>0&&e&&this.#n),this.#r.visible&&(this.#r.scale.setY(2*Lw*Iw*t.spread),this.#r.quaternion.setFromUnitVectors(Nw,new X(...e).sub(this.#n).normalize()))}hasSpread(){return this.#r.visible}mark(t){this.#o.visible=t}goTo(t,e,n){let s=new X(t,e,n);this.#t=this.#n?this.group.position.clone():s,this.#n=s,this.#i=performance.now()}step(){let t=Math.min((performance.now()-this.#i)/Pw,1);return this.group.position.lerpVectors(this.#t,this.#n,t),t<1}top(){return this.group.position.clone().add(new X(-this.#e/2,0,this.#e/2))}};var Ow=1.5,bh=class{group=new On;constructor({parts:t}){let e=(l,c)=>{let h=2*Math.PI*l/t.length;return[c*Math.cos(h),c*Math.sin(h),Ow]},n=[],s=[];t.forEach(([l,c],h)=>{let u=(h+1)%t.length,[f,d]=t[u];if(c===0||d===0)return;let[m,y,p,g]=[e(h,l),e(h,c),e(u,d),e(u,f)];n.push(...m,...y,...p,...m,...p,...g),s.push(...y,...p,...m,...g)});let r=new an().setAttribute("position",new Ce(n,3)),o=new an().setAttribute("position",new Ce(s,3)),a={color:8376715,transparent:!0,opacity:.07,side:ii,depthWrite:!1};this.group.add(new Un(r,new Ss(a)),new Qi(o,new bi({color:5214043})))}standAt([t,e]){this.group.position.set(t,e,0)}};var Bw=new bi({color:16732120,depthTest:!1,transparent:!0}),wh=class{#e=new On;#t=new Map;#n=60;#i=R("span",{id:"truth-note",class:"quiet"});#s=R("input",{type:"checkbox",id:"truth"});#r=R("label",{class:"over",id:"truth-choice",hidden:!0},this.#s," The world\u2019s truth ",this.#i);constructor(t,e){this.view=e,e.scene.add(this.#e),Ut("scene-card").append(this.#r),this.#s.addEventListener("change",()=>{this.#a([]),this.#i.textContent="",t.layTruth(this.#s.checked?(n,s)=>this.#o(n,s):null)})}setCell({truth:t,cube:e}){this.#r.hidden=!t,this.#n=e}#o(t,e){if(!this.#s.checked)return;let n=(t??[]).filter(s=>j(s[0])==="cube"&&j(s[7])!=="gone");this.#i.textContent=t?`pink: ${n.length} objects, known to no agent`:e,this.#a(n)}#a(t){let e=new Set(t.map(n=>j(n[1])));for(let[n,s]of this.#t)e.has(n)||(this.#e.remove(s),this.#t.delete(n));for(let[,n,s,r,o,a]of t){if(!this.#t.has(j(n))){let c=new ya(new pi(this.#n,this.#n,this.#n)),h=new Qi(c,Bw);h.renderOrder=1,this.#t.set(j(n),h),this.#e.add(h)}let l=this.#t.get(j(n));l.position.set(s,r,o),l.rotation.z=a*Math.PI/180}this.view.says("truth",this.#t.size),this.view.ask()}};function _g(i){let t=new Map;for(let[,,,,e]of i.map(pt))for(let[n,s,...r]of e){let o=typeof r[0]=="number"?r[0]:void 0,[,a,l]=r.find(h=>Array.isArray(h)&&j(h[0])==="range")??[],c=t.get(j(n));c&&(c.confidence??0)>=(o??0)||t.set(j(n),{state:j(s),confidence:o,range:a,spread:l})}return t}var If=8;function kw(i){if(!i)return"not looked for";let t=i.confidence===void 0?i.state:`${(i.confidence*100).toFixed(0)} %`,e=i.spread>0?`  \xB1${(2*i.spread).toFixed(1)} mm`:"";return i.state==="seen"?t+e:i.state}function xg(i){let t=Ut("beliefs"),e=[],n=new Map,s=ni(()=>{let r=e.slice(0,If).flatMap(a=>[R("dt",{},Jt(a,16)),R("dd",{},kw(n.get(a)))]),o=e.length>If?[R("dt",{},"and"),R("dd",{},`${e.length-If} more`)]:[];t.replaceChildren(...r,...o)});return i.follow("(place ?name ?x ?y ?z ?frame)",r=>{e=r.map(o=>j(pt(o)[1])).sort(),s()}),r=>{n=r,s()}}function zw(i,t,e){let[,,n,s,r]=e,o=320,a=(i.pan+t.pan)*Math.PI/180,l=(i.tilt+t.tilt)*Math.PI/180,c=new X(-Math.cos(a)*Math.cos(l),Math.sin(a)*Math.cos(l),Math.sin(l)),h=new X(Math.sin(a),Math.cos(a),0),u=new X().crossVectors(c,h).multiplyScalar(-1);u.z<0&&u.negate();let f=new X(...i.at),d=(p,g)=>f.clone().addScaledVector(c,o).addScaledVector(h,p*o*n/2/r).addScaledVector(u,g*o*s/2/r),m=[d(-1,-1),d(1,-1),d(1,1),d(-1,1)],y=m.flatMap((p,g)=>[f,p,p,m[(g+1)%4]]);return new Qi(new an().setFromPoints(y),new bi({color:5223423,transparent:!0,opacity:.6}))}var Vw={pan:0,tilt:0};function yg(i,t){let e=null,n=null,s=null,r=null,o=()=>{r&&t.scene.remove(r);let a=e?.head?s:Vw;r=e&&a&&n?.[4]>0?zw(e,a,n):null,r&&t.scene.add(r),t.says("camera",!!r),t.ask()};return i.follow("(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)",a=>{n=a.length?pt(a[0]):null,o()}),i.follow("(head ?pan ?tilt ?state)",a=>{let[,l,c]=a.length?pt(a[0]):[];s=a.length?{pan:l,tilt:c}:null,o()}),a=>{e=a,o()}}var Gw=i=>i.replace(/\d+\.\d+/g,t=>String(Math.round(t*10)/10));function vg(i,t){let e={},n=()=>{let r=Object.entries(e).filter(([,o])=>o);Ut("readings").replaceChildren(...r.flatMap(([o,a])=>[R("dt",{},o),R("dd",{},a)]))},s=r=>r.map(pt).find(o=>j(o[1])===t.robot);i.follow("(arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz)",r=>{let o=s(r);e.grip=o&&`${o.slice(2,5).map(l=>l.toFixed(0)).join("  ")} mm`;let a=o?.slice(5).map(l=>l.toFixed(0));e.turned=a&&`${a.join("  ")} \xB0`,n()}),i.follow("(arm-joints ?robot ?joints)",r=>{let o=s(r)?.[2];e.joints=o&&o.map(a=>a.toFixed(0)).join("  "),n()}),i.follow("(gripper ?robot ?opening)",r=>{let o=s(r)?.[2];e.gripper=o!==void 0&&`${o.toFixed(0)} mm`,t.open(o),n()}),i.follow("(arm ?robot ?state ?action)",r=>{let o=s(r);e.arm=o&&`${j(o[2])}  ${Gw(j(o[3])).slice(0,40)}`,n()})}var Hw=64,Ww={arms:[],reaches:{},camera:null,cube:60,truth:!1},Lf=class{line=new fo(new an().setFromPoints([new X,new X]),new ba({color:15901498,dashSize:14,gapSize:9}));show(t,e){if(this.line.visible=!!(t&&e),!this.line.visible)return;let n=[t,e].flatMap(s=>[s.x,s.y,s.z]);this.line.geometry.setAttribute("position",new Ce(n,3)),this.line.computeLineDistances()}};function Xw(i,t){let e={servo:"",operation:"",pursued:!1},n=()=>t(e.pursued?e.servo||e.operation:"");i.follow("(servo ?state ?object ?x ?y ?d)",s=>{e.servo=s.length?j(pt(s[0])[2]):"",n()}),i.follow("(operation ?i ?operation ?state)",s=>{let[,,r,o]=s.length?pt(s[0]):[];e.operation=j(o)==="running"?j(r.at(-1)):"",n()}),i.follow("(goal-state ?n ?state ?detail)",s=>{e.pursued=s.some(r=>j(pt(r)[2])==="running"),n()})}function Sg(i){let t=pg(),e=null,n=null,s="",r=Ww,o=new Map,a={robot:"robot",open:p=>t&&e?.open(p)&&t.ask()};vg(i,a);let l=xg(i);if(!t)return{moveArm:()=>{},setCell:p=>a.robot=p.arms[0]??"robot"};let c=new On,h=new Lf,u=yg(i,t),f=new wh(i,t);t.scene.add(c,h.line),t.moving=()=>{let p=e?.step()??!1,g=[...o.values()].map(v=>v.step());return h.show(e?.grip,o.get(s)?.top()),p||g.includes(!0)};let d=()=>{for(let[p,g]of o)g.mark(p===s);t.says("target",o.has(s)?s:""),t.ask()},m=new Map,y=(p,[,,g,v,A])=>{if(!o.has(p)){if(o.size>=Hw)return;o.set(p,new Mh(p,r.cube)),c.add(o.get(p).group)}o.get(p).goTo(g,v,A),o.get(p).believe(m.get(p),r.camera?.at)};return i.follow("(place ?name ?x ?y ?z ?frame)",p=>{let g=new Map(p.map(v=>[j(pt(v)[1]),pt(v)]));for(let[v,A]of o)g.has(v)||(c.remove(A.group),o.delete(v));for(let[v,A]of g)y(v,A);d()}),i.follow("(look ?eyes ?frame ?text ?of)",p=>{m=_g(p);for(let[g,v]of o)v.believe(m.get(g),r.camera?.at);t.says("spread",[...o.values()].filter(g=>g.hasSpread()).length),l(m),t.ask()}),Xw(i,p=>{s=p,d()}),{moveArm:p=>{p.arm===a.robot&&(e||(e=new xh,t.scene.add(e.group)),e.goTo(p),n?.standAt(p.points[0]),t.ask())},setCell:p=>{r=p,a.robot=p.arms[0]??"robot",u(p.camera),f.setCell(p),n&&t.scene.remove(n.group);let g=p.reaches[a.robot];n=g?new bh(g):null,n&&t.scene.add(n.group),t.says("reach",!!n)}}}var qw="uplot",$w="u-hz",Yw="u-vt",Zw="u-title",Jw="u-wrap",Kw="u-under",jw="u-over",Qw="u-axis",yr="u-off",tT="u-select",eT="u-cursor-x",nT="u-cursor-y",iT="u-cursor-pt",sT="u-legend",rT="u-live",oT="u-inline",aT="u-series",lT="u-marker",Mg="u-label",cT="u-value",Xa="width",qa="height";var bg="bottom",bo="left",Df="right",Jf="#000",wg=Jf+"0",Nf="mousemove",Tg="mousedown",Uf="mouseup",Eg="mouseenter",Ag="mouseleave",Cg="dblclick",hT="resize",uT="scroll",Rg="change",Rh="dppxchange",Kf="--",Po=typeof window<"u",zf=Po?document:null,To=Po?window:null,fT=Po?navigator:null,Pe,Th;function Vf(){let i=devicePixelRatio;Pe!=i&&(Pe=i,Th&&Hf(Rg,Th,Vf),Th=matchMedia(`(min-resolution: ${Pe-.001}dppx) and (max-resolution: ${Pe+.001}dppx)`),vr(Rg,Th,Vf),To.dispatchEvent(new CustomEvent(Rh)))}function gi(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Gf(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Ze(i,t,e){i.style[t]=e+"px"}function ki(i,t,e,n){let s=zf.createElement(i);return t!=null&&gi(s,t),e?.insertBefore(s,n),s}function wi(i,t){return ki("div",i,t)}var Pg=new WeakMap;function rs(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Pg.get(i);r!=o&&(i.style.transform=r,Pg.set(i,r),t<0||e<0||t>n||e>s?gi(i,yr):Gf(i,yr))}var Ig=new WeakMap;function Lg(i,t,e){let n=t+e,s=Ig.get(i);n!=s&&(Ig.set(i,n),i.style.background=t,i.style.borderColor=e)}var Dg=new WeakMap;function Ng(i,t,e,n){let s=t+""+e,r=Dg.get(i);s!=r&&(Dg.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var jf={passive:!0},dT={...jf,capture:!0};function vr(i,t,e,n){t.addEventListener(i,e,n?dT:jf)}function Hf(i,t,e,n){t.removeEventListener(i,e,jf)}Po&&Vf();function zi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:_i((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function l0(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var c0=i=>i!=null,h0=i=>i!=null&&i>0,Lh=l0(c0),pT=l0(h0);function mT(i,t,e,n=0,s=!1){let r=s?pT:Lh,o=s?h0:c0;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ve,l??-Ve]}function Dh(i,t,e,n){let s=Og(i),r=Og(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?As:u0,a=s==1?_i:Ti,l=r==1?Ti:_i,c=a(o(En(i))),h=l(o(En(t))),u=Eo(e,c),f=Eo(e,h);return e==10&&(c<0&&(u=Ge(u,-c)),h<0&&(f=Ge(f,-h))),n||e==2?(i=u*s,t=f*r):(i=m0(i,u),t=Nh(t,f)),[i,t]}function Qf(i,t,e,n){let s=Dh(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var td=.1,Ug={mode:3,pad:td},Ya={pad:0,soft:null,mode:0},gT={min:Ya,max:Ya};function Ph(i,t,e,n){return Uh(e)?Fg(i,t,e):(Ya.pad=e,Ya.soft=n?0:null,Ya.mode=n?3:0,Fg(i,t,gT))}function Te(i,t){return i??t}function _T(i,t,e){for(t=Te(t,0),e=Te(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Fg(i,t,e){let n=e.min,s=e.max,r=Te(n.pad,0),o=Te(s.pad,0),a=Te(n.hard,-Ve),l=Te(s.hard,Ve),c=Te(n.soft,Ve),h=Te(s.soft,-Ve),u=Te(n.mode,0),f=Te(s.mode,0),d=t-i,m=As(d),y=ei(En(i),En(t)),p=As(y),g=En(p-m);(d<1e-24||g>10)&&(d=0,(i==0||t==0)&&(d=1e-24,u==2&&c!=Ve&&(r=0),f==2&&h!=-Ve&&(o=0)));let v=d||y||1e3,A=As(v),M=Eo(10,_i(A)),P=v*(d==0?i==0?.1:1:r),E=Ge(m0(i-P,M/10),24),_=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:Ve,T=ei(a,E<_&&i>=_?_:Vi(_,E)),k=v*(d==0?t==0?.1:1:o),U=Ge(Nh(t+k,M/10),24),C=t<=h&&(f==1||f==3&&U>=h||f==2&&U<=h)?h:-Ve,F=Vi(l,U>C&&t<=C?C:ei(C,U));return T==F&&T==0&&(F=100),[T,F]}var xT=new Intl.NumberFormat(Po?fT.language:"en-US"),ed=i=>xT.format(i),xi=Math,Ch=xi.PI,En=xi.abs,_i=xi.floor,Tn=xi.round,Ti=xi.ceil,Vi=xi.min,ei=xi.max,Eo=xi.pow,Og=xi.sign,As=xi.log10,u0=xi.log2,yT=(i,t=1)=>xi.sinh(i)*t,Ff=(i,t=1)=>xi.asinh(i/t),Ve=1/0;function Bg(i){return(As((i^i>>31)-(i>>31))|0)+1}function Wf(i,t,e){return Vi(ei(i,t),e)}function f0(i){return typeof i=="function"}function Me(i){return f0(i)?i:()=>i}var vT=()=>{},d0=i=>i,p0=(i,t)=>t,ST=i=>null,kg=i=>!0,zg=(i,t)=>i==t,MT=/\.\d*?(?=9{6,}|0{6,})/gm,Sr=i=>{if(_0(i)||Qs.has(i))return i;let t=`${i}`,e=t.match(MT);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Sr(s)}e${r}`}return Ge(i,n)};function _r(i,t){return Sr(Ge(Sr(i/t))*t)}function Nh(i,t){return Sr(Ti(Sr(i/t))*t)}function m0(i,t){return Sr(_i(Sr(i/t))*t)}function Ge(i,t=0){if(_0(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Tn(n)/e}var Qs=new Map;function g0(i){return((""+i).split(".")[1]||"").length}function Ja(i,t,e,n){let s=[],r=n.map(g0);for(let o=t;o<e;o++){let a=En(o),l=Ge(Eo(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Ge(h,u);s.push(f),Qs.set(f,u)}}return s}var Za={},nd=[],Ao=[null,null],js=Array.isArray,_0=Number.isInteger,bT=i=>i===void 0;function Vg(i){return typeof i=="string"}function Uh(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function wT(i){return i!=null&&typeof i=="object"}var TT=Object.getPrototypeOf(Uint8Array),x0="__proto__";function Co(i,t=Uh){let e;if(js(i)){let n=i.find(s=>s!=null);if(js(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Co(i[s],t)}else e=i.slice()}else if(i instanceof TT)e=i.slice();else if(t(i)){e={};for(let n in i)n!=x0&&(e[n]=Co(i[n],t))}else e=i;return e}function xn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=x0&&(Uh(i[s])?xn(i[s],Co(n[s])):i[s]=Co(n[s]))}return i}var ET=0,AT=1,CT=2;function RT(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function PT(i,t){if(DT(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return NT(o[0])||(o=LT(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:AT,d=[];for(let m=0;m<h.length;m++){let y=h[m],p=r.get(l[m]);y===null?f!=ET&&(u[p]=y,f==CT&&d.push(p)):u[p]=y}RT(u,d,s),n.push(u)}}return n}var IT=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function LT(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function DT(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function NT(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ei(1,_i((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var y0=["January","February","March","April","May","June","July","August","September","October","November","December"],v0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function S0(i){return i.slice(0,3)}var UT=v0.map(S0),FT=y0.map(S0),OT={MMMM:y0,MMM:FT,WWWW:v0,WWW:UT};function Wa(i){return(i<10?"0":"")+i}function BT(i){return(i<10?"00":i<100?"0":"")+i}var kT={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Wa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Wa(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Wa(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Wa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Wa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>BT(i.getMilliseconds())};function id(i,t){t=t||OT;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?kT[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var zT=new Intl.DateTimeFormat().resolvedOptions().timeZone;function VT(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==zT?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var M0=i=>i%1==0,Ih=[1,2,2.5,5],GT=Ja(10,-32,0,Ih),b0=Ja(10,0,32,Ih),HT=b0.filter(M0),xr=GT.concat(b0),sd=`
`,w0="{YYYY}",Gg=sd+w0,T0="{M}/{D}",$a=sd+T0,Eh=$a+"/{YY}",E0="{aa}",WT="{h}:{mm}",wo=WT+E0,Hg=sd+wo,Wg=":{ss}",Le=null;function A0(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Ja(10,0,3,Ih).filter(M0):Ja(10,-3,0,Ih)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,w0,Le,Le,Le,Le,Le,Le,1],[s*28,"{MMM}",Gg,Le,Le,Le,Le,Le,1],[s,T0,Gg,Le,Le,Le,Le,Le,1],[n,"{h}"+E0,Eh,Le,$a,Le,Le,Le,1],[e,wo,Eh,Le,$a,Le,Le,Le,1],[t,Wg,Eh+" "+wo,Le,$a+" "+wo,Le,Hg,Le,1],[i,Wg+".{fff}",Eh+" "+wo,Le,$a+" "+wo,Le,Hg,Le,1]];function h(u){return(f,d,m,y,p,g)=>{let v=[],A=p>=o,M=p>=r&&p<o,P=u(m),E=Ge(P*i,3),_=Of(P.getFullYear(),A?0:P.getMonth(),M||A?1:P.getDate()),T=Ge(_*i,3);if(M||A){let k=M?p/r:0,U=A?p/o:0,C=E==T?E:Ge(Of(_.getFullYear()+U,_.getMonth()+k,1)*i,3),F=new Date(Tn(C/i)),G=F.getFullYear(),D=F.getMonth();for(let V=0;C<=y;V++){let $=Of(G+U*V,D+k*V,1),H=$-u(Ge($*i,3));C=Ge((+$+H)*i,3),C<=y&&v.push(C)}}else{let k=p>=s?s:p,U=_i(m)-_i(E),C=T+U+Nh(E-T,k);v.push(C);let F=u(C),G=F.getHours()+F.getMinutes()/e+F.getSeconds()/n,D=p/n,V=f.axes[d]._space,$=g/V;for(;C=Ge(C+p,i==1?0:3),!(C>y);)if(D>1){let H=_i(Ge(G+D,6))%24,Q=u(C).getHours()-H;Q>1&&(Q=-1),C-=Q*n,G=(G+D)%24;let rt=v[v.length-1];Ge((C-rt)/p,3)*$>=.7&&v.push(C)}else v.push(C)}return v}}return[l,c,h]}var[XT,qT,$T]=A0(1),[YT,ZT,JT]=A0(.001);Ja(2,-53,53,[1]);function Xg(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function qg(i,t){return(e,n,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,h,u,f,d;return n.map(m=>{let y=i(m),p=y.getFullYear(),g=y.getMonth(),v=y.getDate(),A=y.getHours(),M=y.getMinutes(),P=y.getSeconds(),E=p!=l&&a[2]||g!=c&&a[3]||v!=h&&a[4]||A!=u&&a[5]||M!=f&&a[6]||P!=d&&a[7]||a[1];return l=p,c=g,h=v,u=A,f=M,d=P,E(y)})}}function KT(i,t){let e=id(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Of(i,t,e){return new Date(i,t,e)}function $g(i,t){return t(i)}var jT="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Yg(i,t){return(e,n,s,r)=>r==null?Kf:t(i(n))}function QT(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function tE(i,t){return i.series[t].fill(i,t)}var eE={show:!0,live:!0,isolate:!1,mount:vT,markers:{show:!0,width:2,stroke:QT,fill:tE,dash:"solid"},idx:null,idxs:null,values:[]};function nE(i,t){let e=i.cursor.points,n=wi(),s=e.size(i,t);Ze(n,Xa,s),Ze(n,qa,s);let r=s/-2;Ze(n,"marginLeft",r),Ze(n,"marginTop",r);let o=e.width(i,t,s);return o&&Ze(n,"borderWidth",o),n}function iE(i,t){let e=i.series[t].points;return e._fill||e._stroke}function sE(i,t){let e=i.series[t].points;return e._stroke||e._fill}function rE(i,t){return i.series[t].points.size}var Bf=[0,0];function oE(i,t,e){return Bf[0]=t,Bf[1]=e,Bf}function Ah(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function kf(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var aE={show:!0,x:!0,y:!0,lock:!1,move:oE,points:{one:!1,show:nE,size:rE,width:0,stroke:sE,fill:iE},bind:{mousedown:Ah,mouseup:Ah,click:Ah,dblclick:Ah,mousemove:kf,mouseleave:kf,mouseenter:kf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},C0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},rd=xn({},C0,{filter:p0}),R0=xn({},rd,{size:10}),P0=xn({},C0,{show:!1}),od='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',I0="bold "+od,L0=1.5,Zg={show:!0,scale:"x",stroke:Jf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:I0,side:2,grid:rd,ticks:R0,border:P0,font:od,lineGap:L0,rotate:0},lE="Value",cE="Time",Jg={show:!0,scale:"x",auto:!1,sorted:1,min:Ve,max:-Ve,idxs:[]};function hE(i,t,e,n,s){return t.map(r=>r==null?"":ed(r))}function uE(i,t,e,n,s,r,o){let a=[],l=Qs.get(s)||0;e=o?e:Ge(Nh(e,s),l);for(let c=e;c<=n;c=Ge(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Xf(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?As:u0,h=_i(c(e));s=Eo(l,h),l==10&&(s=xr[zi(s,xr)]);let u=e,f=s*l;l==10&&(f=xr[zi(f,xr)]);do a.push(u),u=u+s,l==10&&!Qs.has(u)&&(u=Ge(u,Qs.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=xr[zi(f,xr)]));while(u<=n);return a}function fE(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Xf(i,t,ei(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Xf(i,t,ei(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}var D0=/./,dE=/[12357]/,pE=/[125]/,Kg=/1/,qf=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function mE(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?D0:l(7,o)-h>=c?dE:l(5,o)-h>=c?pE:Kg;if(u==Kg){let f=En(l(1,o)-h);if(f<c)return qf(t.slice().reverse(),a.distr,u,Ti(c/f)).reverse()}return qf(t,a.distr,u,1)}function gE(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=En(l(1,o)-l(2,o));return c<a?qf(t.slice().reverse(),3,D0,Ti(a/c)).reverse():t}function _E(i,t,e,n){return n==null?Kf:t==null?"":ed(t)}var jg={show:!0,scale:"y",stroke:Jf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:I0,side:3,grid:rd,ticks:R0,border:P0,font:od,lineGap:L0,rotate:0};function xE(i,t){let e=3+(i||1)*2;return Ge(e*t,3)}function yE(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=En(o-r),l=i.series[t],c=a/(l.points.space*Pe);return n[1]-n[0]<=c}var Qg={scale:null,auto:!0,sorted:0,min:Ve,max:-Ve},N0=(i,t,e,n,s)=>s,t0={show:!0,auto:!0,sorted:0,gaps:N0,alpha:1,facets:[xn({},Qg,{scale:"x"}),xn({},Qg,{scale:"y"})]},e0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:N0,alpha:1,points:{show:yE,filter:null},values:null,min:Ve,max:-Ve,idxs:[],path:null,clip:null};function vE(i,t,e,n,s){return e/10}var U0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},SE=xn({},U0,{time:!1,ori:1}),n0={};function F0(i,t){let e=n0[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(n0[i]=e)),e}var Ro=1,$f=2;function Mr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,m=a.width,y=a.height,p=i.valToPosH,g=i.valToPosV;return h.ori==0?e(s,l,c,h,u,p,g,f,d,m,y,Oh,Io,kh,B0,z0):e(s,l,c,h,u,g,p,d,f,y,m,Bh,Lo,cd,k0,V0)}function ad(i,t){let e=0,n=0,s=Te(i.bands,nd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function ME(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Cs(i,t,e,n,s,r){return Mr(i,t,(o,a,l,c,h,u,f,d,m,y,p)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),A=c.ori==0?Io:Lo,M,P;v==1?(M=e,P=n):(M=n,P=e);let E=g(u(a[M],c,y,d)),_=g(f(l[M],h,p,m)),T=g(u(a[P],c,y,d)),k=g(f(r==1?h.max:h.min,h,p,m)),U=new Path2D(s);return A(U,T,k),A(U,E,k),A(U,E,_),U})}function Fh(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?kh:cd,l=e;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function bE(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function ld(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(i[u]),m=f==u?d:r(i[f]),y=u-s;d=o<=0&&y>=0&&y<l?r(i[y]):d;let g=f+s;m=o>=0&&g>=0&&g<l?r(i[g]):m,m>=d&&a.push([d,m])}return a}function i0(i){return i==0?d0:i==1?Tn:t=>_r(t,i)}function O0(i){let t=i==0?Oh:Bh,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Vi(c,a/2,l/2),h=Vi(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var Oh=(i,t,e)=>{i.moveTo(t,e)},Bh=(i,t,e)=>{i.moveTo(e,t)},Io=(i,t,e)=>{i.lineTo(t,e)},Lo=(i,t,e)=>{i.lineTo(e,t)},kh=O0(0),cd=O0(1),B0=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},k0=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},z0=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},V0=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function G0(i){return(t,e,n,s,r)=>Mr(t,e,(o,a,l,c,h,u,f,d,m,y,p)=>{let{pxRound:g,points:v}=o,A,M;c.ori==0?(A=Oh,M=B0):(A=Bh,M=k0);let P=Ge(v.width*Pe,3),E=(v.size-v.width)/2*Pe,_=Ge(E*2,3),T=new Path2D,k=new Path2D,{left:U,top:C,width:F,height:G}=t.bbox;kh(k,U-_,C-_,F+_*2,G+_*2);let D=V=>{if(l[V]!=null){let $=g(u(a[V],c,y,d)),H=g(f(l[V],h,p,m));A(T,$+E,H),M(T,$,H,E,0,Ch*2)}};if(r)r.forEach(D);else for(let V=n;V<=s;V++)D(V);return{stroke:P>0?T:null,fill:T,clip:k,flags:Ro|$f}})}function H0(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var wE=H0(Io),TE=H0(Lo);function W0(i){let t=Te(i?.alignGaps,0);return(e,n,s,r)=>Mr(e,n,(o,a,l,c,h,u,f,d,m,y,p)=>{[s,r]=Lh(l,s,r);let g=o.pxRound,v=G=>g(u(G,c,y,d)),A=G=>g(f(G,h,p,m)),M,P;c.ori==0?(M=Io,P=wE):(M=Lo,P=TE);let E=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ro},T=_.stroke,k=!1;if(r-s>=y*4){let G=ft=>e.posToVal(ft,c.key,!0),D=null,V=null,$,H,ct,J=v(a[E==1?s:r]),Q=v(a[s]),rt=v(a[r]),dt=G(E==1?Q+1:rt-1);for(let ft=E==1?s:r;ft>=s&&ft<=r;ft+=E){let et=a[ft],vt=(E==1?et<dt:et>dt)?J:v(et),Rt=l[ft];vt==J?Rt!=null?(H=Rt,D==null?(M(T,vt,A(H)),$=D=V=H):H<D?D=H:H>V&&(V=H)):Rt===null&&(k=!0):(D!=null&&P(T,J,A(D),A(V),A($),A(H)),Rt!=null?(H=Rt,M(T,vt,A(H)),D=V=$=H):(D=V=null,Rt===null&&(k=!0)),J=vt,dt=G(J+E))}D!=null&&D!=V&&ct!=J&&P(T,J,A(D),A(V),A($),A(H))}else for(let G=E==1?s:r;G>=s&&G<=r;G+=E){let D=l[G];D===null?k=!0:D!=null&&M(T,v(a[G]),A(D))}let[C,F]=ad(e,n);if(o.fill!=null||C!=0){let G=_.fill=new Path2D(T),D=o.fillTo(e,n,o.min,o.max,C),V=A(D),$=v(a[s]),H=v(a[r]);E==-1&&([H,$]=[$,H]),M(G,H,V),M(G,$,V)}if(!o.spanGaps){let G=[];k&&G.push(...ld(a,l,s,r,E,v,t)),_.gaps=G=o.gaps(e,n,s,r,G),_.clip=Fh(G,c.ori,d,m,y,p)}return F!=0&&(_.band=F==2?[Cs(e,n,s,r,T,-1),Cs(e,n,s,r,T,1)]:Cs(e,n,s,r,T,F)),_})}function EE(i){let t=Te(i.align,1),e=Te(i.ascDesc,!1),n=Te(i.alignGaps,0),s=Te(i.extend,!1);return(r,o,a,l)=>Mr(r,o,(c,h,u,f,d,m,y,p,g,v,A)=>{[a,l]=Lh(u,a,l);let M=c.pxRound,{left:P,width:E}=r.bbox,_=Q=>M(m(Q,f,v,p)),T=Q=>M(y(Q,d,A,g)),k=f.ori==0?Io:Lo,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ro},C=U.stroke,F=f.dir*(f.ori==0?1:-1),G=T(u[F==1?a:l]),D=_(h[F==1?a:l]),V=D,$=D;s&&t==-1&&($=P,k(C,$,G)),k(C,D,G);for(let Q=F==1?a:l;Q>=a&&Q<=l;Q+=F){let rt=u[Q];if(rt==null)continue;let dt=_(h[Q]),ft=T(rt);t==1?k(C,dt,G):k(C,V,ft),k(C,dt,ft),G=ft,V=dt}let H=V;s&&t==1&&(H=P+E,k(C,H,G));let[ct,J]=ad(r,o);if(c.fill!=null||ct!=0){let Q=U.fill=new Path2D(C),rt=c.fillTo(r,o,c.min,c.max,ct),dt=T(rt);k(Q,H,dt),k(Q,$,dt)}if(!c.spanGaps){let Q=[];Q.push(...ld(h,u,a,l,F,_,n));let rt=c.width*Pe/2,dt=e||t==1?rt:-rt,ft=e||t==-1?-rt:rt;Q.forEach(et=>{et[0]+=dt,et[1]+=ft}),U.gaps=Q=c.gaps(r,o,a,l,Q),U.clip=Fh(Q,f.ori,p,g,v,A)}return J!=0&&(U.band=J==2?[Cs(r,o,a,l,C,-1),Cs(r,o,a,l,C,1)]:Cs(r,o,a,l,C,J)),U})}function s0(i,t,e,n,s,r,o=Ve){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=En(i[l]-i[a]);h<c&&(c=h,o=En(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function AE(i){i=i||Za;let t=Te(i.size,[.6,Ve,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Me(s),o=1-t[0],a=Te(t[1],Ve),l=Te(t[2],1),c=Te(i.disp,Za),h=Te(i.each,d=>{}),{fill:u,stroke:f}=c;return(d,m,y,p)=>Mr(d,m,(g,v,A,M,P,E,_,T,k,U,C)=>{let F=g.pxRound,G=e,D=n*Pe,V=a*Pe,$=l*Pe,H,ct;M.ori==0?[H,ct]=r(d,m):[ct,H]=r(d,m);let J=M.dir*(M.ori==0?1:-1),Q=M.ori==0?kh:cd,rt=M.ori==0?h:(It,Qt,ce,Tt,ze,Ht,Kt)=>{h(It,Qt,ce,ze,Tt,Kt,Ht)},dt=Te(d.bands,nd).find(It=>It.series[0]==m),ft=dt!=null?dt.dir:0,et=g.fillTo(d,m,g.min,g.max,ft),_t=F(_(et,P,C,k)),vt,Rt,wt,qt=U,le=F(g.width*Pe),Wt=!1,me=null,fe=null,oe=null,Je=null;u!=null&&(le==0||f!=null)&&(Wt=!0,me=u.values(d,m,y,p),fe=new Map,new Set(me).forEach(It=>{It!=null&&fe.set(It,new Path2D)}),le>0&&(oe=f.values(d,m,y,p),Je=new Map,new Set(oe).forEach(It=>{It!=null&&Je.set(It,new Path2D)})));let{x0:He,size:un}=c;if(He!=null&&un!=null){G=1,v=He.values(d,m,y,p),He.unit==2&&(v=v.map(ce=>d.posToVal(T+ce*U,M.key,!0)));let It=un.values(d,m,y,p);un.unit==2?Rt=It[0]*U:Rt=E(It[0],M,U,T)-E(0,M,U,T),qt=s0(v,A,E,M,U,T,qt),wt=qt-Rt+D}else qt=s0(v,A,E,M,U,T,qt),wt=qt*o+D,Rt=qt-wt;wt<1&&(wt=0),le>=Rt/2&&(le=0),wt<5&&(F=d0);let Oe=wt>0,An=qt-wt-(Oe?le:0);Rt=F(Wf(An,$,V)),vt=(G==0?Rt/2:G==J?0:Rt)-G*J*((G==0?D/2:0)+(Oe?le/2:0));let be={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},yn=Wt?null:new Path2D,en=null;if(dt!=null)en=d.data[dt.series[1]];else{let{y0:It,y1:Qt}=c;It!=null&&Qt!=null&&(A=Qt.values(d,m,y,p),en=It.values(d,m,y,p))}let fn=H*Rt,B=ct*Rt;for(let It=J==1?y:p;It>=y&&It<=p;It+=J){let Qt=A[It];if(Qt==null)continue;if(en!=null){let q=en[It]??0;if(Qt-q==0)continue;_t=_(q,P,C,k)}let ce=M.distr!=2||c!=null?v[It]:It,Tt=E(ce,M,U,T),ze=_(Te(Qt,et),P,C,k),Ht=F(Tt-vt),Kt=F(ei(ze,_t)),I=F(Vi(ze,_t)),S=Kt-I;if(Qt!=null){let q=Qt<0?B:fn,ut=Qt<0?fn:B;Wt?(le>0&&oe[It]!=null&&Q(Je.get(oe[It]),Ht,I+_i(le/2),Rt,ei(0,S-le),q,ut),me[It]!=null&&Q(fe.get(me[It]),Ht,I+_i(le/2),Rt,ei(0,S-le),q,ut)):Q(yn,Ht,I+_i(le/2),Rt,ei(0,S-le),q,ut),rt(d,m,It,Ht-le/2,I,Rt+le,S)}}return le>0?be.stroke=Wt?Je:yn:Wt||(be._fill=g.width==0?g._fill:g._stroke??g._fill,be.width=0),be.fill=Wt?fe:yn,be})}function CE(i,t){let e=Te(t?.alignGaps,0);return(n,s,r,o)=>Mr(n,s,(a,l,c,h,u,f,d,m,y,p,g)=>{[r,o]=Lh(c,r,o);let v=a.pxRound,A=H=>v(f(H,h,p,m)),M=H=>v(d(H,u,g,y)),P,E,_;h.ori==0?(P=Oh,_=Io,E=z0):(P=Bh,_=Lo,E=V0);let T=h.dir*(h.ori==0?1:-1),k=A(l[T==1?r:o]),U=k,C=[],F=[];for(let H=T==1?r:o;H>=r&&H<=o;H+=T)if(c[H]!=null){let J=l[H],Q=A(J);C.push(U=Q),F.push(M(c[H]))}let G={stroke:i(C,F,P,_,E,v),fill:null,clip:null,band:null,gaps:null,flags:Ro},D=G.stroke,[V,$]=ad(n,s);if(a.fill!=null||V!=0){let H=G.fill=new Path2D(D),ct=a.fillTo(n,s,a.min,a.max,V),J=M(ct);_(H,U,J),_(H,k,J)}if(!a.spanGaps){let H=[];H.push(...ld(l,c,r,o,T,A,e)),G.gaps=H=a.gaps(n,s,r,o,H),G.clip=Fh(H,h.ori,m,y,p,g)}return $!=0&&(G.band=$==2?[Cs(n,s,r,o,D,-1),Cs(n,s,r,o,D,1)]:Cs(n,s,r,o,D,$)),G})}function RE(i){return CE(PE,i)}function PE(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,t[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,i[f+1],t[f+1])}return a}var Yf=new Set;function r0(){for(let i of Yf)i.syncRect(!0)}Po&&(vr(hT,To,r0),vr(uT,To,r0,!0),vr(Rh,To,()=>{Bn.pxRatio=Pe}));var IE=W0(),LE=G0();function o0(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Zf(r,o,t,e))}function DE(i,t){return i.map((e,n)=>n==0?{}:xn({},t,e))}function Zf(i,t,e,n){return xn({},t==0?e:n,i)}function X0(i,t,e){return t==null?Ao:[t,e]}var NE=X0;function UE(i,t,e){return t==null?Ao:Ph(t,e,td,!0)}function q0(i,t,e,n){return t==null?Ao:Dh(t,e,i.scales[n].log,!1)}var FE=q0;function $0(i,t,e,n){return t==null?Ao:Qf(t,e,i.scales[n].log,!1)}var OE=$0;function BE(i,t,e,n,s){let r=ei(Bg(i),Bg(t)),o=t-i,a=zi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Qs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function a0(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=Tn((e=+s)*Pe))+"px"),[i,t,e]}function kE(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ge(t[2]*Pe,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Bn(i,t,e){let n={mode:Te(i.mode,1)},s=n.mode;function r(x,b,L,N){let W=b.valToPct(x);return N+L*(b.dir==-1?1-W:W)}function o(x,b,L,N){let W=b.valToPct(x);return N+L*(b.dir==-1?W:1-W)}function a(x,b,L,N){return b.ori==0?r(x,b,L,N):o(x,b,L,N)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=wi(qw);if(i.id!=null&&(c.id=i.id),gi(c,i.class),i.title){let x=wi(Zw,c);x.textContent=i.title}let h=ki("canvas"),u=n.ctx=h.getContext("2d"),f=wi(Jw,c);vr("click",f,x=>{x.target===m&&(Xe!=Ir||Ke!=Lr)&&Fn.click(n,x)},!0);let d=n.under=wi(Kw,f);f.appendChild(h);let m=n.over=wi(jw,f);i=Co(i);let y=+Te(i.pxAlign,1),p=i0(y);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let g=i.ms||.001,v=n.series=s==1?o0(i.series||[],Jg,e0,!1):DE(i.series||[null],t0),A=n.axes=o0(i.axes||[],Zg,jg,!0),M=n.scales={},P=n.bands=i.bands||[];P.forEach(x=>{x.fill=Me(x.fill||null),x.dir=Te(x.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,_={axes:hs,series:_e},T=(i.drawOrder||["axes","series"]).map(x=>_[x]);function k(x){let b=x.distr==3?L=>As(L>0?L:x.clamp(n,L,x.min,x.max,x.key)):x.distr==4?L=>Ff(L,x.asinh):x.distr==100?L=>x.fwd(L):L=>L;return L=>{let N=b(L),{_min:W,_max:K}=x,lt=K-W;return(N-W)/lt}}function U(x){let b=M[x];if(b==null){let L=(i.scales||Za)[x]||Za;if(L.from!=null){U(L.from);let N=xn({},M[L.from],L,{key:x});N.valToPct=k(N),M[x]=N}else{b=M[x]=xn({},x==E?U0:SE,L),b.key=x;let N=b.time,W=b.range,K=js(W);if((x!=E||s==2&&!N)&&(K&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Ug:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Ug:{mode:1,hard:W[1],soft:W[1]}},K=!1),!K&&Uh(W))){let lt=W;W=(mt,Mt,Ft)=>Mt==null?Ao:Ph(Mt,Ft,lt)}b.range=Me(W||(N?NE:x==E?b.distr==3?FE:b.distr==4?OE:X0:b.distr==3?q0:b.distr==4?$0:UE)),b.auto=Me(K?!1:b.auto),b.clamp=Me(b.clamp||vE),b._min=b._max=null,b.valToPct=k(b)}}}U("x"),U("y"),s==1&&v.forEach(x=>{U(x.scale)}),A.forEach(x=>{U(x.scale)});for(let x in i.scales)U(x);let C=M[E],F=C.distr,G,D;C.ori==0?(gi(c,$w),G=r,D=o):(gi(c,Yw),G=o,D=r);let V={};for(let x in M){let b=M[x];(b.min!=null||b.max!=null)&&(V[x]={min:b.min,max:b.max},b.min=b.max=null)}let $=i.tzDate||(x=>new Date(Tn(x/g))),H=i.fmtDate||id,ct=g==1?$T($):JT($),J=qg($,Xg(g==1?qT:ZT,H)),Q=Yg($,$g(jT,H)),rt=[],dt=n.legend=xn({},eE,i.legend),ft=n.cursor=xn({},aE,{drag:{y:s==2}},i.cursor),et=dt.show,_t=ft.show,vt=dt.markers;dt.idxs=rt,vt.width=Me(vt.width),vt.dash=Me(vt.dash),vt.stroke=Me(vt.stroke),vt.fill=Me(vt.fill);let Rt,wt,qt,le=[],Wt=[],me,fe=!1,oe={};if(dt.live){let x=v[1]?v[1].values:null;fe=x!=null,me=fe?x(n,1,0):{_:0};for(let b in me)oe[b]=Kf}if(et)if(Rt=ki("table",sT,c),qt=ki("tbody",null,Rt),dt.mount(n,Rt),fe){wt=ki("thead",null,Rt,qt);let x=ki("tr",null,wt);ki("th",null,x);for(var Je in me)ki("th",Mg,x).textContent=Je}else gi(Rt,oT),dt.live&&gi(Rt,rT);let He={show:!0},un={show:!1};function Oe(x,b){if(b==0&&(fe||!dt.live||s==2))return Ao;let L=[],N=ki("tr",aT,qt,qt.childNodes[b]);gi(N,x.class),x.show||gi(N,yr);let W=ki("th",null,N);if(vt.show){let mt=wi(lT,W);if(b>0){let Mt=vt.width(n,b);Mt&&(mt.style.border=Mt+"px "+vt.dash(n,b)+" "+vt.stroke(n,b)),mt.style.background=vt.fill(n,b)}}let K=wi(Mg,W);x.label instanceof HTMLElement?K.appendChild(x.label):K.textContent=x.label,b>0&&(vt.show||(K.style.color=x.width>0?vt.stroke(n,b):vt.fill(n,b)),be("click",W,mt=>{if(ft._lock)return;ee(mt);let Mt=v.indexOf(x);if((mt.ctrlKey||mt.metaKey)!=dt.isolate){let Ft=v.some((Ot,kt)=>kt>0&&kt!=Mt&&Ot.show);v.forEach((Ot,kt)=>{kt>0&&Xi(kt,Ft?kt==Mt?He:un:He,!0,gn.setSeries)})}else Xi(Mt,{show:!x.show},!0,gn.setSeries)},!1),ne&&be(Eg,W,mt=>{ft._lock||(ee(mt),Xi(v.indexOf(x),Nr,!0,gn.setSeries))},!1));for(var lt in me){let mt=ki("td",cT,N);mt.textContent="--",L.push(mt)}return[N,L]}let An=new Map;function be(x,b,L,N=!0){let W=An.get(b)||{},K=ft.bind[x](n,b,L,N);K&&(vr(x,b,W[x]=K),An.set(b,W))}function yn(x,b,L){let N=An.get(b)||{};for(let W in N)(x==null||W==x)&&(Hf(W,b,N[W]),delete N[W]);x==null&&An.delete(b)}let en=0,fn=0,B=0,It=0,Qt=0,ce=0,Tt=Qt,ze=ce,Ht=B,Kt=It,I=0,S=0,q=0,ut=0;n.bbox={};let at=!1,yt=!1,St=!1,nt=!1,st=!1,gt=!1;function O(x,b,L){(L||x!=n.width||b!=n.height)&&ot(x,b),de(!1),St=!0,yt=!0,kn()}function ot(x,b){n.width=en=B=x,n.height=fn=It=b,Qt=ce=0,bt(),Xt();let L=n.bbox;I=L.left=_r(Qt*Pe,.5),S=L.top=_r(ce*Pe,.5),q=L.width=_r(B*Pe,.5),ut=L.height=_r(It*Pe,.5)}let it=3;function Et(){let x=!1,b=0;for(;!x;){b++;let L=Cr(b),N=Wi(b);x=b==it||L&&N,x||(ot(n.width,n.height),yt=!0)}}function xt({width:x,height:b}){O(x,b)}n.setSize=xt;function bt(){let x=!1,b=!1,L=!1,N=!1;A.forEach((W,K)=>{if(W.show&&W._show){let{side:lt,_size:mt}=W,Mt=lt%2,Ft=W.label!=null?W.labelSize:0,Ot=mt+Ft;Ot>0&&(Mt?(B-=Ot,lt==3?(Qt+=Ot,N=!0):L=!0):(It-=Ot,lt==0?(ce+=Ot,x=!0):b=!0))}}),Gi[0]=x,Gi[1]=L,Gi[2]=b,Gi[3]=N,B-=Ei[1]+Ei[3],Qt+=Ei[3],It-=Ei[2]+Ei[0],ce+=Ei[0]}function Xt(){let x=Qt+B,b=ce+It,L=Qt,N=ce;function W(K,lt){switch(K){case 1:return x+=lt,x-lt;case 2:return b+=lt,b-lt;case 3:return L-=lt,L+lt;case 0:return N-=lt,N+lt}}A.forEach((K,lt)=>{if(K.show&&K._show){let mt=K.side;K._pos=W(mt,K._size),K.label!=null&&(K._lpos=W(mt,K.labelSize))}})}if(ft.dataIdx==null){let x=ft.hover,b=x.skip=new Set(x.skip??[]);b.add(void 0);let L=x.prox=Me(x.prox),N=x.bias??=0;ft.dataIdx=(W,K,lt,mt)=>{if(K==0)return lt;let Mt=lt,Ft=L(W,K,lt,mt)??Ve,Ot=Ft>=0&&Ft<Ve,kt=C.ori==0?B:It,ae=ft.left,Ee=t[0],we=t[K];if(b.has(we[lt])){Mt=null;let ye=null,te=null,$t;if(N==0||N==-1)for($t=lt;ye==null&&$t-- >0;)b.has(we[$t])||(ye=$t);if(N==0||N==1)for($t=lt;te==null&&$t++<we.length;)b.has(we[$t])||(te=$t);if(ye!=null||te!=null)if(Ot){let $e=ye==null?-1/0:G(Ee[ye],C,kt,0),rn=te==null?1/0:G(Ee[te],C,kt,0),In=ae-$e,Be=rn-ae;In<=Be?In<=Ft&&(Mt=ye):Be<=Ft&&(Mt=te)}else Mt=te==null?ye:ye==null?te:lt-ye<=te-lt?ye:te}else Ot&&En(ae-G(Ee[lt],C,kt,0))>Ft&&(Mt=null);return Mt}}let ee=x=>{ft.event=x};ft.idxs=rt,ft._lock=!1;let ht=ft.points;ht.show=Me(ht.show),ht.size=Me(ht.size),ht.stroke=Me(ht.stroke),ht.width=Me(ht.width),ht.fill=Me(ht.fill);let zt=n.focus=xn({},i.focus||{alpha:.3},ft.focus),ne=zt.prox>=0,Pt=ne&&ht.one,ue=[],We=[],Hn=[];function Uo(x,b){let L=ht.show(n,b);if(L instanceof HTMLElement)return gi(L,iT),gi(L,x.class),rs(L,-10,-10,B,It),m.insertBefore(L,ue[b]),L}function Tr(x,b){if(s==1||b>0){let L=s==1&&M[x.scale].time,N=x.value;x.value=L?Vg(N)?Yg($,$g(N,H)):N||Q:N||_E,x.label=x.label||(L?cE:lE)}if(Pt||b>0){x.width=x.width==null?1:x.width,x.paths=x.paths||IE||ST,x.fillTo=Me(x.fillTo||ME),x.pxAlign=+Te(x.pxAlign,y),x.pxRound=i0(x.pxAlign),x.stroke=Me(x.stroke||null),x.fill=Me(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let L=xE(ei(1,x.width),1),N=x.points=xn({},{size:L,width:ei(1,L*.2),stroke:x.stroke,space:L*2,paths:LE,_stroke:null,_fill:null},x.points);N.show=Me(N.show),N.filter=Me(N.filter),N.fill=Me(N.fill),N.stroke=Me(N.stroke),N.paths=Me(N.paths),N.pxAlign=x.pxAlign}if(et){let L=Oe(x,b);le.splice(b,0,L[0]),Wt.splice(b,0,L[1]),dt.values.push(null)}if(_t){rt.splice(b,0,null);let L=null;Pt?b==0&&(L=Uo(x,b)):b>0&&(L=Uo(x,b)),ue.splice(b,0,L),We.splice(b,0,0),Hn.splice(b,0,0)}Pn("addSeries",b)}function Wh(x,b){b=b??v.length,x=s==1?Zf(x,b,Jg,e0):Zf(x,b,{},t0),v.splice(b,0,x),Tr(v[b],b)}n.addSeries=Wh;function Ka(x){if(v.splice(x,1),et){dt.values.splice(x,1),Wt.splice(x,1);let b=le.splice(x,1)[0];yn(null,b.firstChild),b.remove()}_t&&(rt.splice(x,1),ue.splice(x,1)[0].remove(),We.splice(x,1),Hn.splice(x,1)),Pn("delSeries",x)}n.delSeries=Ka;let Gi=[!1,!1,!1,!1];function as(x,b){if(x._show=x.show,x.show){let L=x.side%2,N=M[x.scale];N==null&&(x.scale=L?v[1].scale:E,N=M[x.scale]);let W=N.time;x.size=Me(x.size),x.space=Me(x.space),x.rotate=Me(x.rotate),js(x.incrs)&&x.incrs.forEach(lt=>{!Qs.has(lt)&&Qs.set(lt,g0(lt))}),x.incrs=Me(x.incrs||(N.distr==2?HT:W?g==1?XT:YT:xr)),x.splits=Me(x.splits||(W&&N.distr==1?ct:N.distr==3?Xf:N.distr==4?fE:uE)),x.stroke=Me(x.stroke),x.grid.stroke=Me(x.grid.stroke),x.ticks.stroke=Me(x.ticks.stroke),x.border.stroke=Me(x.border.stroke);let K=x.values;x.values=js(K)&&!js(K[0])?Me(K):W?js(K)?qg($,Xg(K,H)):Vg(K)?KT($,K):K||J:K||hE,x.filter=Me(x.filter||(N.distr>=3&&N.log==10?mE:N.distr==3&&N.log==2?gE:p0)),x.font=a0(x.font),x.labelFont=a0(x.labelFont),x._size=x.size(n,null,b,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Gi[b]=!0,x._el=wi(Qw,f))}}function ls(x,b,L,N){let[W,K,lt,mt]=L,Mt=b%2,Ft=0;return Mt==0&&(mt||K)&&(Ft=b==0&&!W||b==2&&!lt?Tn(Zg.size/3):0),Mt==1&&(W||lt)&&(Ft=b==1&&!K||b==3&&!mt?Tn(jg.size/2):0),Ft}let Fo=n.padding=(i.padding||[ls,ls,ls,ls]).map(x=>Me(Te(x,ls))),Ei=n._padding=Fo.map((x,b)=>x(n,b,Gi,0)),nn,ln=null,cn=null,Hi=s==1?v[0].idxs:null,oi=null,Is=!1;function Oo(x,b){if(t=x??[],n.data=n._data=t,s==2){nn=0;for(let L=1;L<v.length;L++)nn+=t[L][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),oi=t[0],nn=oi.length;let L=t;if(F==2){L=t.slice();let N=L[0]=Array(nn);for(let W=0;W<nn;W++)N[W]=W}n._data=t=L}if(de(!0),Pn("setData"),F==2&&(St=!0),b!==!1){let L=C;L.auto(n,Is)?Bo():Ns(E,L.min,L.max),nt=nt||ft.left>=0,gt=!0,kn()}}n.setData=Oo;function Bo(){Is=!0;let x,b;s==1&&(nn>0?(ln=Hi[0]=0,cn=Hi[1]=nn-1,x=t[0][ln],b=t[0][cn],F==2?(x=ln,b=cn):x==b&&(F==3?[x,b]=Dh(x,x,C.log,!1):F==4?[x,b]=Qf(x,x,C.log,!1):C.time?b=x+Tn(86400/g):[x,b]=Ph(x,b,td,!0))):(ln=Hi[0]=x=null,cn=Hi[1]=b=null)),Ns(E,x,b)}let Er,Ls,Ar,w,z,tt,Y,Z,At,Lt;function Ct(x,b,L,N,W,K){x??=wg,L??=nd,N??="butt",W??=wg,K??="round",x!=Er&&(u.strokeStyle=Er=x),W!=Ls&&(u.fillStyle=Ls=W),b!=Ar&&(u.lineWidth=Ar=b),K!=z&&(u.lineJoin=z=K),N!=tt&&(u.lineCap=tt=N),L!=w&&u.setLineDash(w=L)}function Dt(x,b,L,N){b!=Ls&&(u.fillStyle=Ls=b),x!=Y&&(u.font=Y=x),L!=Z&&(u.textAlign=Z=L),N!=At&&(u.textBaseline=At=N)}function Gt(x,b,L,N,W=0){if(N.length>0&&x.auto(n,Is)&&(b==null||b.min==null)){let K=Te(ln,0),lt=Te(cn,N.length-1),mt=L.min==null?mT(N,K,lt,W,x.distr==3):[L.min,L.max];x.min=Vi(x.min,L.min=mt[0]),x.max=ei(x.max,L.max=mt[1])}}let se={min:null,max:null};function ge(){for(let N in M){let W=M[N];V[N]==null&&(W.min==null||V[E]!=null&&W.auto(n,Is))&&(V[N]=se)}for(let N in M){let W=M[N];V[N]==null&&W.from!=null&&V[W.from]!=null&&(V[N]=se)}V[E]!=null&&de(!0);let x={};for(let N in V){let W=V[N];if(W!=null){let K=x[N]=Co(M[N],wT);if(W.min!=null)xn(K,W);else if(N!=E||s==2)if(nn==0&&K.from==null){let lt=K.range(n,null,null,N);K.min=lt[0],K.max=lt[1]}else K.min=Ve,K.max=-Ve}}if(nn>0){v.forEach((N,W)=>{if(s==1){let K=N.scale,lt=V[K];if(lt==null)return;let mt=x[K];if(W==0){let Mt=mt.range(n,mt.min,mt.max,K);mt.min=Mt[0],mt.max=Mt[1],ln=zi(mt.min,t[0]),cn=zi(mt.max,t[0]),cn-ln>1&&(t[0][ln]<mt.min&&ln++,t[0][cn]>mt.max&&cn--),N.min=oi[ln],N.max=oi[cn]}else N.show&&N.auto&&Gt(mt,lt,N,t[W],N.sorted);N.idxs[0]=ln,N.idxs[1]=cn}else if(W>0&&N.show&&N.auto){let[K,lt]=N.facets,mt=K.scale,Mt=lt.scale,[Ft,Ot]=t[W],kt=x[mt],ae=x[Mt];kt!=null&&Gt(kt,V[mt],K,Ft,K.sorted),ae!=null&&Gt(ae,V[Mt],lt,Ot,lt.sorted),N.min=lt.min,N.max=lt.max}});for(let N in x){let W=x[N],K=V[N];if(W.from==null&&(K==null||K.min==null)){let lt=W.range(n,W.min==Ve?null:W.min,W.max==-Ve?null:W.max,N);W.min=lt[0],W.max=lt[1]}}}for(let N in x){let W=x[N];if(W.from!=null){let K=x[W.from];if(K.min==null)W.min=W.max=null;else{let lt=W.range(n,K.min,K.max,N);W.min=lt[0],W.max=lt[1]}}}let b={},L=!1;for(let N in x){let W=x[N],K=M[N];if(K.min!=W.min||K.max!=W.max){K.min=W.min,K.max=W.max;let lt=K.distr;K._min=lt==3?As(K.min):lt==4?Ff(K.min,K.asinh):lt==100?K.fwd(K.min):K.min,K._max=lt==3?As(K.max):lt==4?Ff(K.max,K.asinh):lt==100?K.fwd(K.max):K.max,b[N]=L=!0}}if(L){v.forEach((N,W)=>{s==2?W>0&&b.y&&(N._paths=null):b[N.scale]&&(N._paths=null)});for(let N in b)St=!0,Pn("setScale",N);_t&&ft.left>=0&&(nt=gt=!0)}for(let N in V)V[N]=null}function Vt(x){let b=Wf(ln-1,0,nn-1),L=Wf(cn+1,0,nn-1);for(;x[b]==null&&b>0;)b--;for(;x[L]==null&&L<nn-1;)L++;return[b,L]}function _e(){if(nn>0){let x=v.some(b=>b._focus)&&Lt!=zt.alpha;x&&(u.globalAlpha=Lt=zt.alpha),v.forEach((b,L)=>{if(L>0&&b.show&&(Qe(L,!1),Qe(L,!0),b._paths==null)){let N=Lt;Lt!=b.alpha&&(u.globalAlpha=Lt=b.alpha);let W=s==2?[0,t[L][0].length-1]:Vt(t[L]);b._paths=b.paths(n,L,W[0],W[1]),Lt!=N&&(u.globalAlpha=Lt=N)}}),v.forEach((b,L)=>{if(L>0&&b.show){let N=Lt;Lt!=b.alpha&&(u.globalAlpha=Lt=b.alpha),b._paths!=null&&De(L,!1);{let W=b._paths!=null?b._paths.gaps:null,K=b.points.show(n,L,ln,cn,W),lt=b.points.filter(n,L,K,W);(K||lt)&&(b.points._paths=b.points.paths(n,L,ln,cn,lt),De(L,!0))}Lt!=N&&(u.globalAlpha=Lt=N),Pn("drawSeries",L)}}),x&&(u.globalAlpha=Lt=1)}}function Qe(x,b){let L=b?v[x].points:v[x];L._stroke=L.stroke(n,x),L._fill=L.fill(n,x)}function De(x,b){let L=b?v[x].points:v[x],{stroke:N,fill:W,clip:K,flags:lt,_stroke:mt=L._stroke,_fill:Mt=L._fill,_width:Ft=L.width}=L._paths;Ft=Ge(Ft*Pe,3);let Ot=null,kt=Ft%2/2;b&&Mt==null&&(Mt=Ft>0?"#fff":mt);let ae=L.pxAlign==1&&kt>0;if(ae&&u.translate(kt,kt),!b){let Ee=I-Ft/2,we=S-Ft/2,ye=q+Ft,te=ut+Ft;Ot=new Path2D,Ot.rect(Ee,we,ye,te)}b?Bt(mt,Ft,L.dash,L.cap,Mt,N,W,lt,K):Ne(x,mt,Ft,L.dash,L.cap,Mt,N,W,lt,Ot,K),ae&&u.translate(-kt,-kt)}function Ne(x,b,L,N,W,K,lt,mt,Mt,Ft,Ot){let kt=!1;Mt!=0&&P.forEach((ae,Ee)=>{if(ae.series[0]==x){let we=v[ae.series[1]],ye=t[ae.series[1]],te=(we._paths||Za).band;js(te)&&(te=ae.dir==1?te[0]:te[1]);let $t,$e=null;we.show&&te&&_T(ye,ln,cn)?($e=ae.fill(n,Ee)||K,$t=we._paths.clip):te=null,Bt(b,L,N,W,$e,lt,mt,Mt,Ft,Ot,$t,te),kt=!0}}),kt||Bt(b,L,N,W,K,lt,mt,Mt,Ft,Ot)}let vn=Ro|$f;function Bt(x,b,L,N,W,K,lt,mt,Mt,Ft,Ot,kt){Ct(x,b,L,N,W),(Mt||Ft||kt)&&(u.save(),Mt&&u.clip(Mt),Ft&&u.clip(Ft)),kt?(mt&vn)==vn?(u.clip(kt),Ot&&u.clip(Ot),ve(W,lt),dn(x,K,b)):mt&$f?(ve(W,lt),u.clip(kt),dn(x,K,b)):mt&Ro&&(u.save(),u.clip(kt),Ot&&u.clip(Ot),ve(W,lt),u.restore(),dn(x,K,b)):(ve(W,lt),dn(x,K,b)),(Mt||Ft||kt)&&u.restore()}function dn(x,b,L){L>0&&(b instanceof Map?b.forEach((N,W)=>{u.strokeStyle=Er=W,u.stroke(N)}):b!=null&&x&&u.stroke(b))}function ve(x,b){b instanceof Map?b.forEach((L,N)=>{u.fillStyle=Ls=N,u.fill(L)}):b!=null&&x&&u.fill(b)}function cs(x,b,L,N){let W=A[x],K;if(N<=0)K=[0,0];else{let lt=W._space=W.space(n,x,b,L,N),mt=W._incrs=W.incrs(n,x,b,L,N,lt);K=BE(b,L,mt,N,lt)}return W._found=K}function pn(x,b,L,N,W,K,lt,mt,Mt,Ft){let Ot=lt%2/2;y==1&&u.translate(Ot,Ot),Ct(mt,lt,Mt,Ft,mt),u.beginPath();let kt,ae,Ee,we,ye=W+(N==0||N==3?-K:K);L==0?(ae=W,we=ye):(kt=W,Ee=ye);for(let te=0;te<x.length;te++)b[te]!=null&&(L==0?kt=Ee=x[te]:ae=we=x[te],u.moveTo(kt,ae),u.lineTo(Ee,we));u.stroke(),y==1&&u.translate(-Ot,-Ot)}function Cr(x){let b=!0;return A.forEach((L,N)=>{if(!L.show)return;let W=M[L.scale];if(W.min==null){L._show&&(b=!1,L._show=!1,de(!1));return}else L._show||(b=!1,L._show=!0,de(!1));let K=L.side,lt=K%2,{min:mt,max:Mt}=W,[Ft,Ot]=cs(N,mt,Mt,lt==0?B:It);if(Ot==0)return;let kt=W.distr==2,ae=L._splits=L.splits(n,N,mt,Mt,Ft,Ot,kt),Ee=W.distr==2?ae.map($t=>oi[$t]):ae,we=W.distr==2?oi[ae[1]]-oi[ae[0]]:Ft,ye=L._values=L.values(n,L.filter(n,Ee,N,Ot,we),N,Ot,we);L._rotate=K==2?L.rotate(n,ye,N,Ot):0;let te=L._size;L._size=Ti(L.size(n,ye,N,x)),te!=null&&L._size!=te&&(b=!1)}),b}function Wi(x){let b=!0;return Fo.forEach((L,N)=>{let W=L(n,N,Gi,x);W!=Ei[N]&&(b=!1),Ei[N]=W}),b}function hs(){for(let x=0;x<A.length;x++){let b=A[x];if(!b.show||!b._show)continue;let L=b.side,N=L%2,W,K,lt=b.stroke(n,x),mt=L==0||L==3?-1:1,[Mt,Ft]=b._found;if(b.label!=null){let qn=b.labelGap*mt,ci=Tn((b._lpos+qn)*Pe);Dt(b.labelFont[0],lt,"center",L==2?"top":bg),u.save(),N==1?(W=K=0,u.translate(ci,Tn(S+ut/2)),u.rotate((L==3?-Ch:Ch)/2)):(W=Tn(I+q/2),K=ci);let ir=f0(b.label)?b.label(n,x,Mt,Ft):b.label;u.fillText(ir,W,K),u.restore()}if(Ft==0)continue;let Ot=M[b.scale],kt=N==0?q:ut,ae=N==0?I:S,Ee=b._splits,we=Ot.distr==2?Ee.map(qn=>oi[qn]):Ee,ye=Ot.distr==2?oi[Ee[1]]-oi[Ee[0]]:Mt,te=b.ticks,$t=b.border,$e=te.show?te.size:0,rn=Tn($e*Pe),In=Tn((b.alignTo==2?b._size-$e-b.gap:b.gap)*Pe),Be=b._rotate*-Ch/180,on=p(b._pos*Pe),ai=(rn+In)*mt,Xn=on+ai;K=N==0?Xn:0,W=N==1?Xn:0;let yi=b.font[0],Ai=b.align==1?bo:b.align==2?Df:Be>0?bo:Be<0?Df:N==0?"center":L==3?Df:bo,$i=Be||N==1?"middle":L==2?"top":bg;Dt(yi,lt,Ai,$i);let li=b.font[1]*b.lineGap,vi=Ee.map(qn=>p(a(qn,Ot,kt,ae))),Ci=b._values;for(let qn=0;qn<Ci.length;qn++){let ci=Ci[qn];if(ci!=null){N==0?W=vi[qn]:K=vi[qn],ci=""+ci;let ir=ci.indexOf(`
`)==-1?[ci]:ci.split(/\n/gm);for(let $n=0;$n<ir.length;$n++){let Dd=ir[$n];Be?(u.save(),u.translate(W,K+$n*li),u.rotate(Be),u.fillText(Dd,0,0),u.restore()):u.fillText(Dd,W,K+$n*li)}}}te.show&&pn(vi,te.filter(n,we,x,Ft,ye),N,L,on,rn,Ge(te.width*Pe,3),te.stroke(n,x),te.dash,te.cap);let Yi=b.grid;Yi.show&&pn(vi,Yi.filter(n,we,x,Ft,ye),N,N==0?2:1,N==0?S:I,N==0?ut:q,Ge(Yi.width*Pe,3),Yi.stroke(n,x),Yi.dash,Yi.cap),$t.show&&pn([on],[1],N==0?1:0,N==0?1:2,N==1?S:I,N==1?ut:q,Ge($t.width*Pe,3),$t.stroke(n,x),$t.dash,$t.cap)}Pn("drawAxes")}function de(x){v.forEach((b,L)=>{L>0&&(b._paths=null,x&&(s==1?(b.min=null,b.max=null):b.facets.forEach(N=>{N.min=null,N.max=null})))})}let sn=!1,Wn=!1,Ue=[];function mn(){Wn=!1;for(let x=0;x<Ue.length;x++)Pn(...Ue[x]);Ue.length=0}function kn(){sn||(IT(md),sn=!0)}function ja(x,b=!1){sn=!0,Wn=b,x(n),md(),b&&Ue.length>0&&queueMicrotask(mn)}n.batch=ja;function md(){if(at&&(ge(),at=!1),St&&(Et(),St=!1),yt){if(Ze(d,bo,Qt),Ze(d,"top",ce),Ze(d,Xa,B),Ze(d,qa,It),Ze(m,bo,Qt),Ze(m,"top",ce),Ze(m,Xa,B),Ze(m,qa,It),Ze(f,Xa,en),Ze(f,qa,fn),h.width=Tn(en*Pe),h.height=Tn(fn*Pe),A.forEach(({_el:x,_show:b,_size:L,_pos:N,side:W})=>{if(x!=null)if(b){let K=W===3||W===0?L:0,lt=W%2==1;Ze(x,lt?"left":"top",N-K),Ze(x,lt?"width":"height",L),Ze(x,lt?"top":"left",lt?ce:Qt),Ze(x,lt?"height":"width",lt?It:B),Gf(x,yr)}else gi(x,yr)}),Er=Ls=Ar=z=tt=Y=Z=At=w=null,Lt=1,Vo(!0),Qt!=Tt||ce!=ze||B!=Ht||It!=Kt){de(!1);let x=B/Ht,b=It/Kt;if(_t&&!nt&&ft.left>=0){ft.left*=x,ft.top*=b,Rr&&rs(Rr,Tn(ft.left),0,B,It),Pr&&rs(Pr,0,Tn(ft.top),B,It);for(let L=0;L<ue.length;L++){let N=ue[L];N!=null&&(We[L]*=x,Hn[L]*=b,rs(N,Ti(We[L]),Ti(Hn[L]),B,It))}}if(qe.show&&!st&&qe.left>=0&&qe.width>0){qe.left*=x,qe.width*=x,qe.top*=b,qe.height*=b;for(let L in Jh)Ze(Dr,L,qe[L])}Tt=Qt,ze=ce,Ht=B,Kt=It}Pn("setSize"),yt=!1}en>0&&fn>0&&(u.clearRect(0,0,h.width,h.height),Pn("drawClear"),T.forEach(x=>x()),Pn("draw")),qe.show&&st&&(Qa(qe),st=!1),_t&&nt&&(nr(null,!0,!1),nt=!1),dt.show&&dt.live&&gt&&(Yh(),gt=!1),l||(l=!0,n.status=1,Pn("ready")),Is=!1,sn=!1}n.redraw=(x,b)=>{St=b||!1,x!==!1?Ns(E,C.min,C.max):kn()};function Xh(x,b){let L=M[x];if(L.from==null){if(nn==0){let N=L.range(n,b.min,b.max,x);b.min=N[0],b.max=N[1]}if(b.min>b.max){let N=b.min;b.min=b.max,b.max=N}if(nn>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;x==E&&L.distr==2&&nn>0&&(b.min=zi(b.min,t[0]),b.max=zi(b.max,t[0]),b.min==b.max&&b.max++),V[x]=b,at=!0,kn()}}n.setScale=Xh;let qh,$h,Rr,Pr,gd,_d,Ir,Lr,xd,yd,Xe,Ke,Ds=!1,Fn=ft.drag,Cn=Fn.x,Rn=Fn.y;_t&&(ft.x&&(qh=wi(eT,m)),ft.y&&($h=wi(nT,m)),C.ori==0?(Rr=qh,Pr=$h):(Rr=$h,Pr=qh),Xe=ft.left,Ke=ft.top);let qe=n.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Dr=qe.show?wi(tT,qe.over?m:d):null;function Qa(x,b){if(qe.show){for(let L in x)qe[L]=x[L],L in Jh&&Ze(Dr,L,x[L]);b!==!1&&Pn("setSelect")}}n.setSelect=Qa;function b_(x){if(v[x].show)et&&Gf(le[x],yr);else if(et&&gi(le[x],yr),_t){let L=Pt?ue[0]:ue[x];L!=null&&rs(L,-10,-10,B,It)}}function Ns(x,b,L){Xh(x,{min:b,max:L})}function Xi(x,b,L,N){b.focus!=null&&C_(x),b.show!=null&&v.forEach((W,K)=>{K>0&&(x==K||x==null)&&(W.show=b.show,b_(K),s==2?(Ns(W.facets[0].scale,null,null),Ns(W.facets[1].scale,null,null)):Ns(W.scale,null,null),kn())}),L!==!1&&Pn("setSeries",x,b),N&&Go("setSeries",n,x,b)}n.setSeries=Xi;function w_(x,b){xn(P[x],b)}function T_(x,b){x.fill=Me(x.fill||null),x.dir=Te(x.dir,-1),b=b??P.length,P.splice(b,0,x)}function E_(x){x==null?P.length=0:P.splice(x,1)}n.addBand=T_,n.setBand=w_,n.delBand=E_;function A_(x,b){v[x].alpha=b,_t&&ue[x]!=null&&(ue[x].style.opacity=b),et&&le[x]&&(le[x].style.opacity=b)}let us,Us,er,Nr={focus:!0};function C_(x){if(x!=er){let b=x==null,L=zt.alpha!=1;v.forEach((N,W)=>{if(s==1||W>0){let K=b||W==0||W==x;N._focus=b?null:K,L&&A_(W,K?1:zt.alpha)}}),er=x,L&&kn()}}et&&ne&&be(Ag,Rt,x=>{ft._lock||(ee(x),er!=null&&Xi(null,Nr,!0,gn.setSeries))});function qi(x,b,L){let N=M[b];L&&(x=x/Pe-(N.ori==1?ce:Qt));let W=B;N.ori==1&&(W=It,x=W-x),N.dir==-1&&(x=W-x);let K=N._min,lt=N._max,mt=x/W,Mt=K+(lt-K)*mt,Ft=N.distr;return Ft==3?Eo(10,Mt):Ft==4?yT(Mt,N.asinh):Ft==100?N.bwd(Mt):Mt}function R_(x,b){let L=qi(x,E,b);return zi(L,t[0],ln,cn)}n.valToIdx=x=>zi(x,t[0]),n.posToIdx=R_,n.posToVal=qi,n.valToPos=(x,b,L)=>M[b].ori==0?r(x,M[b],L?q:B,L?I:0):o(x,M[b],L?ut:It,L?S:0),n.setCursor=(x,b,L)=>{Xe=x.left,Ke=x.top,nr(null,b,L)};function vd(x,b){Ze(Dr,bo,qe.left=x),Ze(Dr,Xa,qe.width=b)}function Sd(x,b){Ze(Dr,"top",qe.top=x),Ze(Dr,qa,qe.height=b)}let ko=C.ori==0?vd:Sd,zo=C.ori==1?vd:Sd;function P_(){if(et&&dt.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&fe)continue;let b=dt.values[x],L=0;for(let N in b)Wt[x][L++].firstChild.nodeValue=b[N]}}function Yh(x,b){if(x!=null&&(x.idxs?x.idxs.forEach((L,N)=>{rt[N]=L}):bT(x.idx)||rt.fill(x.idx),dt.idx=rt[0]),et&&dt.live){for(let L=0;L<v.length;L++)(L>0||s==1&&!fe)&&I_(L,rt[L]);P_()}gt=!1,b!==!1&&Pn("setLegend")}n.setLegend=Yh;function I_(x,b){let L=v[x],N=x==0&&F==2?oi:t[x],W;fe?W=L.values(n,x,b)??oe:(W=L.value(n,b==null?null:N[b],x,b),W=W==null?oe:{_:W}),dt.values[x]=W}function nr(x,b,L){xd=Xe,yd=Ke,[Xe,Ke]=ft.move(n,Xe,Ke),ft.left=Xe,ft.top=Ke,_t&&(Rr&&rs(Rr,Tn(Xe),0,B,It),Pr&&rs(Pr,0,Tn(Ke),B,It));let N,W=ln>cn;us=Ve,Us=null;let K=C.ori==0?B:It,lt=C.ori==1?B:It;if(Xe<0||nn==0||W){N=ft.idx=null;for(let mt=0;mt<v.length;mt++){let Mt=ue[mt];Mt!=null&&rs(Mt,-10,-10,B,It)}ne&&Xi(null,Nr,!0,x==null&&gn.setSeries),dt.live&&(rt.fill(N),gt=!0)}else{let mt,Mt,Ft;s==1&&(mt=C.ori==0?Xe:Ke,Mt=qi(mt,E),N=ft.idx=zi(Mt,t[0],ln,cn),Ft=G(t[0][N],C,K,0));let Ot=-10,kt=-10,ae=0,Ee=0,we=!0,ye="",te="";for(let $t=s==2?1:0;$t<v.length;$t++){let $e=v[$t],rn=rt[$t],In=rn==null?null:s==1?t[$t][rn]:t[$t][1][rn],Be=ft.dataIdx(n,$t,N,Mt),on=Be==null?null:s==1?t[$t][Be]:t[$t][1][Be];if(gt=gt||on!=In||Be!=rn,rt[$t]=Be,$t>0&&$e.show){let ai=Be==null?-10:Be==N?Ft:G(s==1?t[0][Be]:t[$t][0][Be],C,K,0),Xn=on==null?-10:D(on,s==1?M[$e.scale]:M[$e.facets[1].scale],lt,0);if(ne&&on!=null){let yi=C.ori==1?Xe:Ke,Ai=En(zt.dist(n,$t,Be,Xn,yi));if(Ai<us){let $i=zt.bias;if($i!=0){let li=qi(yi,$e.scale),vi=on>=0?1:-1,Ci=li>=0?1:-1;Ci==vi&&(Ci==1?$i==1?on>=li:on<=li:$i==1?on<=li:on>=li)&&(us=Ai,Us=$t)}else us=Ai,Us=$t}}if(gt||Pt){let yi,Ai;C.ori==0?(yi=ai,Ai=Xn):(yi=Xn,Ai=ai);let $i,li,vi,Ci,Yi,qn,ci=!0,ir=ht.bbox;if(ir!=null){ci=!1;let $n=ir(n,$t);vi=$n.left,Ci=$n.top,$i=$n.width,li=$n.height}else vi=yi,Ci=Ai,$i=li=ht.size(n,$t);if(qn=ht.fill(n,$t),Yi=ht.stroke(n,$t),Pt)$t==Us&&us<=zt.prox&&(Ot=vi,kt=Ci,ae=$i,Ee=li,we=ci,ye=qn,te=Yi);else{let $n=ue[$t];$n!=null&&(We[$t]=vi,Hn[$t]=Ci,Ng($n,$i,li,ci),Lg($n,qn,Yi),rs($n,Ti(vi),Ti(Ci),B,It))}}}}if(Pt){let $t=zt.prox,$e=er==null?us<=$t:us>$t||Us!=er;if(gt||$e){let rn=ue[0];rn!=null&&(We[0]=Ot,Hn[0]=kt,Ng(rn,ae,Ee,we),Lg(rn,ye,te),rs(rn,Ti(Ot),Ti(kt),B,It))}}}if(qe.show&&Ds)if(x!=null){let[mt,Mt]=gn.scales,[Ft,Ot]=gn.match,[kt,ae]=x.cursor.sync.scales,Ee=x.cursor.drag;if(Cn=Ee._x,Rn=Ee._y,Cn||Rn){let{left:we,top:ye,width:te,height:$t}=x.select,$e=x.scales[kt].ori,rn=x.posToVal,In,Be,on,ai,Xn,yi=mt!=null&&Ft(mt,kt),Ai=Mt!=null&&Ot(Mt,ae);yi&&Cn?($e==0?(In=we,Be=te):(In=ye,Be=$t),on=M[mt],ai=G(rn(In,kt),on,K,0),Xn=G(rn(In+Be,kt),on,K,0),ko(Vi(ai,Xn),En(Xn-ai))):ko(0,K),Ai&&Rn?($e==1?(In=we,Be=te):(In=ye,Be=$t),on=M[Mt],ai=D(rn(In,ae),on,lt,0),Xn=D(rn(In+Be,ae),on,lt,0),zo(Vi(ai,Xn),En(Xn-ai))):zo(0,lt)}else Kh()}else{let mt=En(xd-gd),Mt=En(yd-_d);if(C.ori==1){let ae=mt;mt=Mt,Mt=ae}Cn=Fn.x&&mt>=Fn.dist,Rn=Fn.y&&Mt>=Fn.dist;let Ft=Fn.uni;Ft!=null?Cn&&Rn&&(Cn=mt>=Ft,Rn=Mt>=Ft,!Cn&&!Rn&&(Mt>mt?Rn=!0:Cn=!0)):Fn.x&&Fn.y&&(Cn||Rn)&&(Cn=Rn=!0);let Ot,kt;Cn&&(C.ori==0?(Ot=Ir,kt=Xe):(Ot=Lr,kt=Ke),ko(Vi(Ot,kt),En(kt-Ot)),Rn||zo(0,lt)),Rn&&(C.ori==1?(Ot=Ir,kt=Xe):(Ot=Lr,kt=Ke),zo(Vi(Ot,kt),En(kt-Ot)),Cn||ko(0,K)),!Cn&&!Rn&&(ko(0,0),zo(0,0))}if(Fn._x=Cn,Fn._y=Rn,x==null){if(L){if(Ld!=null){let[mt,Mt]=gn.scales;gn.values[0]=mt!=null?qi(C.ori==0?Xe:Ke,mt):null,gn.values[1]=Mt!=null?qi(C.ori==1?Xe:Ke,Mt):null}Go(Nf,n,Xe,Ke,B,It,N)}if(ne){let mt=L&&gn.setSeries,Mt=zt.prox;er==null?us<=Mt&&Xi(Us,Nr,!0,mt):us>Mt?Xi(null,Nr,!0,mt):Us!=er&&Xi(Us,Nr,!0,mt)}}gt&&(dt.idx=N,Yh()),b!==!1&&Pn("setCursor")}let Fs=null;Object.defineProperty(n,"rect",{get(){return Fs==null&&Vo(!1),Fs}});function Vo(x=!1){x?Fs=null:(Fs=m.getBoundingClientRect(),Pn("syncRect",Fs))}function Md(x,b,L,N,W,K,lt){ft._lock||Ds&&x!=null&&x.movementX==0&&x.movementY==0||(Zh(x,b,L,N,W,K,lt,!1,x!=null),x!=null?nr(null,!0,!0):nr(b,!0,!1))}function Zh(x,b,L,N,W,K,lt,mt,Mt){if(Fs==null&&Vo(!1),ee(x),x!=null)L=x.clientX-Fs.left,N=x.clientY-Fs.top;else{if(L<0||N<0){Xe=-10,Ke=-10;return}let[Ft,Ot]=gn.scales,kt=b.cursor.sync,[ae,Ee]=kt.values,[we,ye]=kt.scales,[te,$t]=gn.match,$e=b.axes[0].side%2==1,rn=C.ori==0?B:It,In=C.ori==1?B:It,Be=$e?K:W,on=$e?W:K,ai=$e?N:L,Xn=$e?L:N;if(we!=null?L=te(Ft,we)?a(ae,M[Ft],rn,0):-10:L=rn*(ai/Be),ye!=null?N=$t(Ot,ye)?a(Ee,M[Ot],In,0):-10:N=In*(Xn/on),C.ori==1){let yi=L;L=N,N=yi}}Mt&&(b==null||b.cursor.event.type==Nf)&&((L<=1||L>=B-1)&&(L=_r(L,B)),(N<=1||N>=It-1)&&(N=_r(N,It))),mt?(gd=L,_d=N,[Ir,Lr]=ft.move(n,L,N)):(Xe=L,Ke=N)}let Jh={width:0,height:0,left:0,top:0};function Kh(){Qa(Jh,!1)}let bd,wd,Td,Ed;function Ad(x,b,L,N,W,K,lt){Ds=!0,Cn=Rn=Fn._x=Fn._y=!1,Zh(x,b,L,N,W,K,lt,!0,!1),x!=null&&(be(Uf,zf,Cd,!1),Go(Tg,n,Ir,Lr,B,It,null));let{left:mt,top:Mt,width:Ft,height:Ot}=qe;bd=mt,wd=Mt,Td=Ft,Ed=Ot}function Cd(x,b,L,N,W,K,lt){Ds=Fn._x=Fn._y=!1,Zh(x,b,L,N,W,K,lt,!1,!0);let{left:mt,top:Mt,width:Ft,height:Ot}=qe,kt=Ft>0||Ot>0,ae=bd!=mt||wd!=Mt||Td!=Ft||Ed!=Ot;if(kt&&ae&&Qa(qe),Fn.setScale&&kt&&ae){let Ee=mt,we=Ft,ye=Mt,te=Ot;if(C.ori==1&&(Ee=Mt,we=Ot,ye=mt,te=Ft),Cn&&Ns(E,qi(Ee,E),qi(Ee+we,E)),Rn)for(let $t in M){let $e=M[$t];$t!=E&&$e.from==null&&$e.min!=Ve&&Ns($t,qi(ye+te,$t),qi(ye,$t))}Kh()}else ft.lock&&(ft._lock=!ft._lock,nr(b,!0,x!=null));x!=null&&(yn(Uf,zf),Go(Uf,n,Xe,Ke,B,It,null))}function L_(x,b,L,N,W,K,lt){if(ft._lock)return;ee(x);let mt=Ds;if(Ds){let Mt=!0,Ft=!0,Ot=10,kt,ae;C.ori==0?(kt=Cn,ae=Rn):(kt=Rn,ae=Cn),kt&&ae&&(Mt=Xe<=Ot||Xe>=B-Ot,Ft=Ke<=Ot||Ke>=It-Ot),kt&&Mt&&(Xe=Xe<Ir?0:B),ae&&Ft&&(Ke=Ke<Lr?0:It),nr(null,!0,!0),Ds=!1}Xe=-10,Ke=-10,rt.fill(null),nr(null,!0,!0),mt&&(Ds=mt)}function Rd(x,b,L,N,W,K,lt){ft._lock||(ee(x),Bo(),Kh(),x!=null&&Go(Cg,n,Xe,Ke,B,It,null))}function Pd(){A.forEach(kE),O(n.width,n.height,!0)}vr(Rh,To,Pd);let Ur={};Ur.mousedown=Ad,Ur.mousemove=Md,Ur.mouseup=Cd,Ur.dblclick=Rd,Ur.setSeries=(x,b,L,N)=>{let W=gn.match[2];L=W(n,b,L),L!=-1&&Xi(L,N,!0,!1)},_t&&(be(Tg,m,Ad),be(Nf,m,Md),be(Eg,m,x=>{ee(x),Vo(!1)}),be(Ag,m,L_),be(Cg,m,Rd),Yf.add(n),n.syncRect=Vo);let tl=n.hooks=i.hooks||{};function Pn(x,b,L){Wn?Ue.push([x,b,L]):x in tl&&tl[x].forEach(N=>{N.call(null,n,b,L)})}(i.plugins||[]).forEach(x=>{for(let b in x.hooks)tl[b]=(tl[b]||[]).concat(x.hooks[b])});let Id=(x,b,L)=>L,gn=xn({key:null,setSeries:!1,filters:{pub:kg,sub:kg},scales:[E,v[1]?v[1].scale:null],match:[zg,zg,Id],values:[null,null]},ft.sync);gn.match.length==2&&gn.match.push(Id),ft.sync=gn;let Ld=gn.key,jh=F0(Ld);function Go(x,b,L,N,W,K,lt){gn.filters.pub(x,b,L,N,W,K,lt)&&jh.pub(x,b,L,N,W,K,lt)}jh.sub(n);function D_(x,b,L,N,W,K,lt){gn.filters.sub(x,b,L,N,W,K,lt)&&Ur[x](null,b,L,N,W,K,lt)}n.pub=D_;function N_(){jh.unsub(n),Yf.delete(n),An.clear(),Hf(Rh,To,Pd),c.remove(),Rt?.remove(),Pn("destroy")}n.destroy=N_;function Qh(){Pn("init",i,t),Oo(t||i.data,!1),V[E]?Xh(E,V[E]):Bo(),st=qe.show&&(qe.width>0||qe.height>0),nt=gt=!0,O(i.width,i.height)}return v.forEach(Tr),A.forEach(as),e?e instanceof HTMLElement?(e.appendChild(c),Qh()):e(n,Qh):Qh(),n}Bn.assign=xn;Bn.fmtNum=ed;Bn.rangeNum=Ph;Bn.rangeLog=Dh;Bn.rangeAsinh=Qf;Bn.orient=Mr;Bn.pxRatio=Pe;Bn.join=PT;Bn.fmtDate=id,Bn.tzDate=VT;Bn.sync=F0;{Bn.addGap=bE,Bn.clipGaps=Fh;let i=Bn.paths={points:G0};i.linear=W0,i.stepped=EE,i.bars=AE,i.spline=RE}var zE=20,VE=["up","align x","align depth","approach","fine"];function Y0(i){let t=Ut("servo-plot"),e=[],n=[[],[],[]],s={stroke:"#9fb0bd",grid:{stroke:"#263642",width:1},ticks:{show:!1},font:"11px system-ui"},r=(l,c)=>({label:l,stroke:c,width:1.5,points:{show:!1}}),o=new Bn({width:Math.max(t.clientWidth,120),height:118,legend:{show:!0,live:!1},cursor:{show:!1},scales:{x:{time:!1}},axes:[{...s,size:22,values:(l,c)=>c.map(h=>`${h} s`)},{...s,size:38}],series:[{},r("x px","#4fb3ff"),r("y px","#7fd18b"),r("d mm","#f2a33a")]},[[],[],[],[]],t);new ResizeObserver(()=>o.setSize({width:Math.max(t.clientWidth,120),height:118})).observe(t);let a=ni(()=>{let l=e.at(-1);o.setData([e.map(c=>Math.round((c-l)*100)/100),...n])});i.follow("(servo ?state ?object ?x ?y ?d)",l=>{if(l.length===0){Ut("servo-note").textContent="at rest";return}let[,c,h,...u]=pt(l[0]);for(Ut("servo-note").textContent=`${VE[c]??c}: ${j(h)}`,e.push(l[0].facts[0].when/1e6),u.forEach((f,d)=>n[d].push(f));e[0]<e.at(-1)-zE;){e.shift();for(let f of n)f.shift()}a()})}function Z0(i,t){let e=Ut("stop-note"),n=a=>e.textContent=a,s=async()=>{try{await i.stop("the operator's STOP"),n("STOP is told")}catch(a){n(`STOP was NOT told: ${Ae(a)}`)}};Ut("stop").addEventListener("click",s);let r=a=>{a.key==="Escape"&&!a.repeat&&s()};window.addEventListener("keydown",r,{capture:!0});let o=Ut("clear-stops");o.addEventListener("click",async()=>{if(await sl("Is everybody out of the way? Clearing the stop lets the arm move again."))try{await i.clearStops(),n("Escape, from anywhere")}catch(a){n(Ae(a))}}),t.onChange(a=>{o.disabled=!a,o.title=a?"":"Take the arm in hand first (Drive): who clears a stop sets it free"}),i.followAlways("(stop ?who ?reason)",a=>{Ut("stopped").hidden=a.length===0;let l=a.map(c=>`${j(pt(c)[1])}: ${j(pt(c)[2])}`);Ut("stopped-by").textContent=Jt(l.join("; "))})}var hd=50,GE={reached:"good",running:"busy",kept:"good"},HE=i=>Array.isArray(i)&&j(i[0])==="fail"?j(i[2]):"";function J0(i){let t=R("span",{class:"quiet"},""),e=R("tbody",{}),n=["","Goal","Outcome","Since"].map(l=>R("th",{},l)),s=R("table",{id:"goals"},R("thead",{},R("tr",{},...n)),e),r=new Map,o=new Map,a=()=>{let l=[...new Set([...r.keys(),...o.keys()])].sort((h,u)=>u-h);t.textContent=l.length>hd?`${l.length}, ${hd} shown`:String(l.length);let c=l.slice(0,hd).map(h=>{let u=o.get(h),f=u?j(pt(u)[2]):"asked for",d=u?HE(pt(u)[3]):"";return R("tr",{},R("td",{},String(h)),R("td",{},R("code",{},Jt((r.get(h)??[]).map(Fe).join(" "),200))),R("td",{},R("span",{class:`chip ${GE[f]??"warn"}`},f),d&&` ${Jt(d)}`),R("td",{},u?tn(u.facts[0].when):""))});e.replaceChildren(...c)};return i.follow("(goal ?n ?facts)",l=>{r=new Map(l.map(pt).map(([,c,h])=>[c,h])),a()}),i.follow("(goal-state ?n ?state ?detail)",l=>{o=new Map(l.map(c=>[pt(c)[1],c])),a()}),R("details",{class:"goals"},R("summary",{},"Goals so far ",t),s)}function K0(i,t,e){let n=R("canvas",{role:"img","aria-label":`What was seen at ${tn(e)}`,hidden:!0}),s=R("figcaption",{class:"quiet"},"looking for the picture \u2026");return(async()=>{if(!t)return s.textContent="no stream of images is told";try{let o=await i.picture(t,e);ml(n,o),o.bitmap.close(),n.hidden=!1,s.textContent=`frame ${o.number}, ${tn(o.captured)}`}catch(o){s.textContent=Ae(o)}})(),R("figure",{class:"kept"},n,s)}function WE(i,t){let e=Array.from({length:i.length+1},()=>Array(t.length+1).fill(0));for(let o=i.length-1;o>=0;--o)for(let a=t.length-1;a>=0;--a)e[o][a]=i[o]===t[a]?e[o+1][a+1]+1:Math.max(e[o+1][a],e[o][a+1]);let n=[],s=0,r=0;for(;s<i.length||r<t.length;)s<i.length&&r<t.length&&i[s]===t[r]?n.push([i[s++],t[r++]]):r===t.length||s<i.length&&e[s+1][r]>=e[s][r+1]?n.push([i[s++],null]):n.push([null,t[r++]]);return n}function j0(i,t,e){let n=(r,o,a)=>R("td",{class:r?o:""},r&&R("code",{},Jt(r,80)),r&&a&&R("small",{},` ${a}`)),s=WE(i.map(Fe),t.map(Fe)).map(([r,o])=>R("tr",{},n(r,o?"kept":"dropped",o?"":e.has(r)?"begun":"dropped"),n(o,r?"kept":"made",r?"kept":"new")));return R("table",{class:"plans"},R("thead",{},R("tr",{},R("th",{},"The plan before"),R("th",{},"From here on"))),R("tbody",{},...s))}function br(i){return Array.isArray(i)&&j(i[0])==="plan"&&Array.isArray(i[2])?{goal:i[1],operations:i[2]}:null}var Ps=["Goals","Plans","Operations","Servo","Sightings","Differences","Refusals","Faults"],XE=["up","align x","align depth","approach","fine"],qE={plan:"Plans",operation:"Operations",servo:"Servo",difference:"Differences",missing:"Differences",agent:"Faults"},$E=new Set(["operation","plan","result","goal"]),Rs=i=>i.facts[0].when,YE=i=>Array.isArray(i)&&j(i[0])==="fail";function Q0(i){let t=i.map(e=>({answer:e,event:pt(e),when:Rs(e)}));return t.flatMap(({answer:e,event:[,,n,s,r],when:o},a)=>{let l=YE(r),c=l?"Faults":qE[j(n)];if(!c)return[];let h=c==="Operations"&&t.slice(a+1).find(({event:u})=>$E.has(j(u[2])));return[{lane:c,from:o,until:h?h.when:o,kind:l?"bad":j(n),label:j(s),answer:e}]})}function t_(i,t,e){let n=new Map(t.map(s=>[pt(s)[1],s]));return i.flatMap(s=>{let[,r,o]=pt(s),a=n.get(r),l=a?j(pt(a)[2]):"asked for",c=`goal ${r} ${l}: ${o.map(Fe).join(" ")}`,h=a&&l!=="running"?Rs(a):e,u={lane:"Goals",from:Rs(s),until:h,kind:l,label:c,answer:a??s};return l==="refused"?[u,{...u,lane:"Refusals",from:h,kind:"bad"}]:[u]})}function e_(i){return i.map(t=>{let[,e,n,s,r]=pt(t),o=`${j(e)}: ${j(n)}, ${s} times: ${j(r)}`;return{lane:"Refusals",from:Rs(t),until:Rs(t),kind:"bad",label:o,answer:t}})}function n_(i){return i.map(t=>{let[,e,n,s,r]=pt(t),o=`${j(e)}: ${j(n)} ${j(s)} since frame ${r}`;return{lane:"Sightings",from:Rs(t),until:Rs(t),kind:j(s),label:o,answer:t}})}function i_(i){return i.map(({answer:t,until:e})=>{let[,n,s]=pt(t),r=`servo ${XE[n]??n}: ${j(s)}`;return{lane:"Servo",from:Rs(t),until:e??Rs(t),kind:`state-${n}`,label:r,answer:t}})}function s_(i,t){let e=[],n=new Map;for(let s of i.toSorted((r,o)=>r.from-o.from)){let r=`${s.lane} ${s.kind}`,o=n.get(r);if(o&&s.from-o.from<t)o.marks.push(s),o.until=Math.max(o.until,s.until);else{let a={lane:s.lane,kind:s.kind,from:s.from,until:s.until,marks:[s]};n.set(r,a),e.push(a)}}return e}var ud=76,wr=19,Do=18,r_=5,ZE=6e7,o_=[1,2,5,10,20,60,120].map(i=>i*ZE),JE=i=>tn(i).slice(0,5);function a_({lane:i,marks:t,from:e}){let n=t.length>1?` and ${t.length-1} more`:"";return`${i}, ${tn(e)}: ${Jt(t[0].label,160)}${n}`}var zh=class{#e;#t=Sn("g",{});#n=Sn("g",{});#i=new Map;#s="";panel;constructor(t){this.#e=t;let e=Do+Ps.length*wr;this.panel=Sn("svg",{id:"work",height:e,width:"100%",role:"group","aria-label":"What happened, over time"},this.#t,this.#n),this.panel.addEventListener("keydown",n=>this.#d(n))}draw(t,e,n){let s=Math.max(this.panel.clientWidth-ud-4,100),r=c=>ud+s*(Math.min(Math.max(c,e),n)-e)/(n-e),o=t.filter(c=>c.until>=e&&c.from<=n),a=s_(o,r_*(n-e)/s);this.#r(r,s,e,n);let l=new Map(a.map(c=>[`${c.lane} ${c.kind} ${c.from}`,c]));for(let[c,{made:h}]of this.#i)l.has(c)||(h.remove(),this.#i.delete(c));for(let[c,h]of l)this.#o(c,h,r);this.#u()}#r(t,e,n,s){let r=o_.find(l=>(s-n)/l<=8)??o_.at(-1),o=[];for(let l=Math.ceil(n/r)*r;l<=s;l+=r)o.push(l);let a=Do+Ps.length*wr;this.#t.replaceChildren(...Ps.map((l,c)=>Sn("text",{x:0,y:Do+c*wr+13,class:"lane"},l)),...Ps.map((l,c)=>Sn("rect",{x:ud,y:Do+c*wr+1,width:e,height:wr-2,class:"lane"})),...o.map(l=>Sn("line",{x1:t(l),x2:t(l),y1:Do,y2:a,class:"tick"})),...o.map(l=>Sn("text",{x:t(l),y:12,class:"tick"},JE(l))))}#o(t,e,n){let s=this.#i.get(t)??this.#a(t,e);s.group=e,s.title.textContent=a_(e);let{made:r}=s,o=n(e.from);r.setAttribute("x",o),r.setAttribute("y",Do+Ps.indexOf(e.lane)*wr+3),r.setAttribute("width",Math.max(n(e.until)-o,r_)),r.setAttribute("aria-label",a_(e))}#a(t,e){let n=Sn("title",{}),s=Sn("rect",{height:wr-6,rx:2,role:"button",tabindex:-1,class:`mark ${e.kind}`,"data-lane":e.lane},n);return s.addEventListener("click",()=>this.#c(t)),s.addEventListener("focus",()=>{this.#s=t,this.#u()}),this.#n.append(s),this.#i.set(t,{made:s,title:n,group:e}),this.#i.get(t)}#c(t){this.#e(this.#i.get(t).group.marks)}#u(){this.#i.has(this.#s)||(this.#s=this.#f().at(-1)?.[0]??"");for(let[t,{made:e}]of this.#i)e.setAttribute("tabindex",t===this.#s?0:-1)}#f(){return[...this.#i].sort(([,t],[,e])=>t.group.from-e.group.from)}#d(t){let e=this.#i.get(this.#s);if(!e)return;if(t.key==="Enter"||t.key===" ")return t.preventDefault(),this.#c(this.#s);let n={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[t.key],s=n&&(n[0]?this.#p(e,n[0]):this.#h(e,n[1]));s&&(t.preventDefault(),s.made.focus())}#p(t,e){let n=this.#f().filter(([,{group:s}])=>s.lane===t.group.lane);return n[n.findIndex(([,s])=>s===t)+e]?.[1]}#h(t,e){let n=({group:s})=>Math.abs(s.from-t.group.from);for(let s=Ps.indexOf(t.group.lane)+e;s>=0&&s<Ps.length;s+=e){let r=[...this.#i.values()].filter(({group:o})=>o.lane===Ps[s]);if(r.length)return r.sort((o,a)=>n(o)-n(a))[0]}}};var KE=[["10 minutes",6e8],["1 hour",36e8],["8 hours",8*36e8]],l_=2e3,fd=20,jE=5e3;function QE(i,t){let e=[];return i.follow("(servo ?state ?object ?x ?y ?d)",n=>{if(i.moment!==null)return;let s=e.at(-1),[r]=n,o=r&&s&&!s.ended&&pt(s.answer)[1]===pt(r)[1];if(s&&!s.ended&&(s.until=r?r.facts[0].when:s.until),o)return t();s&&(s.ended=!0),r&&e.push({answer:r,until:r.facts[0].when,ended:!1}),e.length>l_&&e.shift(),t()}),e}function t1(i,t){let e=new Map;return i.follow("(tracked ?eyes ?name ?state ?frame ?confidence)",n=>{for(let s of n)e.set(s.ids[0],s);for(let s of[...e.keys()].slice(0,Math.max(0,e.size-l_)))e.delete(s);t()}),e}function c_(i,t,e){let n=R("div",{class:"timeline",id:"opened",hidden:!0}),s=({answer:m,label:y})=>R("details",{},R("summary",{},R("time",{},tn(m.facts[0].when)),Jt(y)),R("p",{class:"quiet"},kr(m.ids[0],m.facts[0]))),r=m=>{let y=m.slice(0,fd).map(v=>pt(v.answer)[0].name==="event"?e(v.answer):s(v)),p=m.length>fd?[R("p",{class:"quiet"},`and ${m.length-fd} more`)]:[],g=R("button",{type:"button",class:"small",onclick:()=>n.hidden=!0},"Close");n.replaceChildren(g,...y,...p),n.hidden=!1,y[0].open=!0},o=new zh(r),a=R("select",{"aria-label":"How much of the past"},...KE.map(([m,y])=>R("option",{value:y,selected:m==="1 hour"},m))),l={goals:[],states:[],refusals:[]},c=ni(()=>{if(o.panel.clientWidth===0)return;let m=i.moment??Date.now()*1e3,y=m-Number(a.value);t.reach(y);let p=[...t_(l.goals,l.states,m),...Q0(t.until(m)),...i_(h.filter(g=>g.until<=m)),...n_([...u.values()].filter(g=>g.facts[0].when<=m)),...e_(l.refusals)];o.draw(p,y,m)}),h=QE(i,c),u=t1(i,c),f=(m,y)=>i.follow(m,p=>{l[y]=p,c()});return f("(goal ?n ?facts)","goals"),f("(goal-state ?n ?state ?detail)","states"),f("(board-refusal ?client ?symbol ?count ?sentence)","refusals"),a.addEventListener("change",c),new ResizeObserver(c).observe(o.panel),setInterval(c,jE),{panel:R("section",{"aria-label":"Over time"},R("div",{class:"row"},R("h2",{},"Over time"),R("label",{},"The last ",a)),o.panel,n),draw:c}}var h_="(event ?n ?kind ?sentence ?detail)",dd=5e3,tr=i=>i.facts[0].when,No=i=>`${pt(i)[1]}@${tr(i)}`,Vh=class{#e;#t=new Map;#n=!1;#i=!1;#s=[];constructor(t){this.#e=t,t.follow(h_,e=>{this.#o(e),this.#r()})}onChange(t){this.#s.push(t)}#r(){for(let t of this.#s)t()}until(t){return[...this.#t.values()].filter(n=>tr(n)<=t).sort((n,s)=>tr(n)-tr(s)||pt(n)[1]-pt(s)[1])}async reach(t){if(!(this.#n||this.#i)){for(this.#n=!0;!this.#i&&this.#t.size<dd;){let e=this.until(1/0)[0];if(!e||pt(e)[1]<=1||tr(e)<=t)break;let n=this.#t.size;this.#o(await this.#e.askThen(h_,tr(e)).catch(()=>[])),this.#i=this.#t.size===n,this.#r()}this.#n=!1}}#o(t){for(let n of t)this.#t.set(No(n),n);if(this.#t.size<=dd)return;let e=[...this.#t].sort(([,n],[,s])=>tr(n)-tr(s)).slice(0,this.#t.size-dd);for(let[n]of e)this.#t.delete(n)}};var e1=200;function n1(i,t,e){let n=i.map(pt).filter(o=>o[1]<t),s=n.filter(o=>br(o[4])?.goal===e).toSorted((o,a)=>a[1]-o[1])[0];if(!s)return null;let r=n.filter(o=>o[1]>s[1]&&j(o[2])==="operation").map(o=>Fe(o[4]));return{operations:br(s[4]).operations,begun:new Set(r)}}function i1(i,t,e){let n=br(e),s=n&&n1(i,t,n.goal);return s?j0(s.operations,n.operations,s.begun):R("pre",{},Jt(Fe(e),4e3))}function s1({connection:i,images:t,goTo:e},n,s){let[,r,o,a,l]=pt(s),c=s.facts[0],h=R("summary",{},R("time",{},tn(c.when)),R("span",{class:`kind ${j(o)}`},j(o)),R("span",{},Jt(j(a)))),u=R("div",{});return R("details",{"data-number":r,ontoggle:d=>d.target.open&&u.replaceChildren(K0(i,t.telling(),c.when))},h,R("p",{class:"quiet"},kr(s.ids[0],c)),R("button",{type:"button",class:"small",onclick:()=>e(c.when)},"Show all as it was then"),u,np(i,s.ids[0],c),i1(n,r,l))}function u_(i,t,e,n){let s=R("div",{class:"timeline"}),r=R("pre",{class:"answer",hidden:!0}),o=async()=>{r.hidden=!1;try{r.textContent=(await i.request("coordinator","(why)")).map(f=>Jt(f,1e3)).join(`
`)}catch(f){r.textContent=Ae(f)}},a=()=>t.until(i.moment??1/0),l=f=>s1({connection:i,images:e,goTo:n},a(),f),c=c_(i,t,l);Ut("story").append(R("div",{class:"row"},R("button",{type:"button",id:"why",onclick:o},"Why this, now?")),r,c.panel,J0(i),s);let h=new Map,u=ni(()=>{let f=a().reverse().slice(0,e1),d=new Set(f.map(No));for(let m of h.keys())d.has(m)||h.delete(m);for(let m of f)h.has(No(m))||h.set(No(m),l(m));s.replaceChildren(...f.map(m=>h.get(No(m)))),c.draw()});t.onChange(u)}function f_(){let i=[...document.querySelectorAll("[role=tab]")],t=e=>{for(let n of i)n.setAttribute("aria-selected",String(n===e)),n.tabIndex=n===e?0:-1,document.getElementById(n.getAttribute("aria-controls")).hidden=n!==e};i.forEach((e,n)=>{e.addEventListener("click",()=>t(e)),e.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowLeft:-1}[s.key];if(!r)return;let o=i[(n+r+i.length)%i.length];t(o),o.focus()})}),t(i[0])}var r1=12;function d_(i,t){let e=R("ul",{id:`${i.id}-words`,class:"words",role:"listbox","aria-label":"What may come next",hidden:!0});i.after(e);for(let[h,u]of Object.entries({role:"combobox","aria-autocomplete":"list","aria-expanded":"false","aria-controls":e.id}))i.setAttribute(h,u);let n={from:0,words:[]},s=-1,r=h=>{if(s=h,[...e.children].forEach((u,f)=>u.setAttribute("aria-selected",String(f===s))),s<0)return i.removeAttribute("aria-activedescendant");i.setAttribute("aria-activedescendant",e.children[s].id),e.children[s].scrollIntoView({block:"nearest"})},o=()=>{e.hidden=!0,r(-1),i.setAttribute("aria-expanded","false")},a=h=>{let u=i.selectionStart;i.setRangeText(n.words[h].put,n.from,u,"end"),i.dispatchEvent(new Event("input",{bubbles:!0}))},l=()=>{n=t(i.value.slice(0,i.selectionStart));let h=n.words.slice(0,r1).map(({word:u},f)=>{let d=R("li",{role:"option",id:`${e.id}-${f}`,"aria-selected":"false"},u);return d.addEventListener("pointerdown",m=>{m.preventDefault(),a(f)}),d});if(e.replaceChildren(...h),h.length===0)return o();e.hidden=!1,i.setAttribute("aria-expanded","true"),r(-1)},c=()=>i.selectionStart>n.from;i.addEventListener("input",l),i.addEventListener("blur",o),i.addEventListener("keydown",h=>{let u=e.children.length;e.hidden?h.key==="ArrowDown"&&l():h.key==="ArrowDown"||h.key==="ArrowUp"?(h.preventDefault(),r((s+(h.key==="ArrowDown"?1:s<0?0:-1)+u)%u)):h.key==="Enter"&&s>=0||h.key==="Tab"&&!h.shiftKey&&(s>=0||c())?(h.preventDefault(),a(Math.max(s,0))):(h.key==="Enter"||h.key==="Escape")&&o()})}var p_=["and","or","not","then","keep"];function o1(i){let t=[];for(let[s]of i.matchAll(/[()]|[^\s()]+/g))s==="("?t.push([]):s===")"?(t.pop(),t.at(-1)?.push("()")):t.at(-1)?.push(s);if(t.length===0)return null;let[e="",...n]=t.at(-1);return{head:e,rest:n}}function m_(i,{predicates:t,names:e}){let n=i.match(/[^\s()]*$/)[0],s=i.slice(0,i.length-n.length),r=o1(s),o=[...t.keys(),...p_],a=(f,d)=>f.filter(m=>m!==n&&m.startsWith(n.toLowerCase())).map(m=>({word:m,put:d(m)})),l=f=>({from:s.length,words:f});if(!r&&n===""&&s.trim()!=="")return l([]);if(!r||p_.includes(r.head))return l(a(o,f=>`(${f} `));if(r.head==="")return l(a(o,f=>`${f}${t.get(f)===0?")":" "}`));let c=t.get(r.head.toLowerCase());if(c===void 0)return l(a(e,f=>`${f} `));let h=c-r.rest.length;if(h<=0)return l([]);let u=e.filter(f=>!r.rest.includes(f));return l(a(u,f=>`${f}${h===1?")":" "}`))}var a1=(i,t)=>t.every((e,n)=>e===i[i.length-t.length+n]);function l1(i,t,e){let n=e.findLastIndex(s=>{let r=br(s[4]);return r?.goal===i&&r.operations.map(Fe).join()===t.join()});return e.slice(n+1)}function g_(i,t,e){let[,n,s]=i,r=s.map(Fe),o=new Set,a=new Set,l=1/0;for(let[,,u,,f]of l1(n,r,e.map(pt))){let d=br(f)?.operations.map(Fe);if(j(u)==="operation")o.add(Fe(f));else if(d&&d.length<r.length&&a1(r,d)){l=r.length-d.length;for(let m of r.slice(l))for(let y of[o,a])y.delete(m)}else if(j(u)==="difference"&&Array.isArray(f))for(let m of f.map(Fe))r.includes(m)&&a.add(m)}let c=t&&pt(t),h=c&&Fe(c[2])===r[c[1]];return r.map((u,f)=>h&&f===c[1]?j(c[3]):h&&f<c[1]?a.has(u)?"skipped":"done":a.has(u)?"skipped":f>=l?"still serves":"")}var __="the table",c1=16,pd=class{#e=[];#t=new Map;#n="";#i="";#s=R("div",{class:"towers",role:"group","aria-label":"Towers"});panel=R("div",{id:"sketch",hidden:!0});constructor(t){this.written=t;let e=R("button",{type:"button",onclick:()=>this.#u()},"Clear");this.panel.append(this.#s,R("div",{class:"row"},R("span",{class:"quiet"},"Drag a block onto another."),e)),this.#s.addEventListener("pointerup",n=>this.#f(n)),this.#s.addEventListener("pointercancel",()=>this.#i="")}setNames(t){this.#e=t.slice(0,c1);for(let[e,n]of this.#t)(!this.#e.includes(e)||!this.#e.includes(n))&&this.#t.delete(e);this.#h()}#r(t){return[...this.#t].find(([,e])=>e===t)?.[0]}#o(t){let e=this.#r(t);return e?[t,...this.#o(e)]:[t]}#a(t,e){if(this.#n="",e===__)this.#t.delete(t);else if(t!==e&&!this.#o(t).includes(e)){let n=this.#c(e);this.#t.delete(t),this.#t.set(t,this.#o(n).at(-1))}this.#h(),this.written(this.#e.flatMap(n=>this.#t.has(n)?[`(on ${n} ${this.#t.get(n)})`]:[]).join(" "))}#c(t){return this.#t.has(t)?this.#c(this.#t.get(t)):t}#u(){this.#t.clear(),this.#n="",this.#h(),this.written("")}#f(t){let e=this.#i;if(this.#i="",!e)return;let n=document.elementFromPoint(t.clientX,t.clientY)?.closest("[data-block], .towers");!n||n.dataset.block===e||this.#a(e,n.dataset.block??__)}#d(t){if(this.#n&&this.#n!==t)return this.#a(this.#n,t);this.#n=this.#n?"":t,this.#h()}#p(t){let e=R("button",{type:"button",class:"block","data-block":t,"aria-pressed":String(t===this.#n)},Jt(t,20));return e.addEventListener("pointerdown",n=>{this.#i=t,e.releasePointerCapture?.(n.pointerId)}),e.addEventListener("click",()=>this.#d(t)),e}#h(){let t=this.#e.filter(e=>!this.#t.has(e));this.#s.replaceChildren(...t.map(e=>R("div",{class:"tower"},...this.#o(e).toReversed().map(n=>this.#p(n)))))}};function x_(){let i=new pd(n=>Ut("goal-text").value=n),t=R("button",{type:"button",id:"sketch-toggle","aria-expanded":"false","aria-controls":"sketch"},"Sketch"),e=n=>{i.panel.hidden=!n,t.setAttribute("aria-expanded",String(n))};return t.addEventListener("click",()=>e(i.panel.hidden)),Ut("goal-form").addEventListener("submit",()=>e(!1)),Ut("cancel").before(t),Ut("goal-answer").before(i.panel),i}var h1="end-effector",u1={"still serves":"serves"};function f1(i,t){let e=Ut("plan");if(e.replaceChildren(),Ut("plan-note").textContent=i?`for goal ${i[1]}`:"none yet",!i)return;i[2].forEach((s,r)=>{let o=t[r],a=R("li",{class:u1[o]??o},R("code",{},Jt(Fe(s),80)));o&&a.append(R("span",{class:"mark"},o)),o==="running"&&a.setAttribute("aria-current","step"),e.append(a)});let n=e.querySelector(".running");n&&(e.scrollTop=n.offsetTop-e.offsetTop-e.clientHeight/2)}function d1(i,t){let e=Number(t.place?.match(/^goal:1:(\d+)/)?.[1]??0);if(i.setAttribute("aria-invalid","true"),e===0)return;let n=i.value.slice(e-1).match(/^[()]|^[^\s()]+/)?.[0]??" ";i.focus(),i.setSelectionRange(e-1,e-1+n.length)}function p1(i){let t=new Map;for(let[,,e]of i.map(pt)){let n=r=>e.filter(o=>j(o[0])===r).flatMap(o=>o.slice(1));if(!n("offers").some(r=>j(r[0])==="goal"))continue;let s=new Set(n("reads").map(j));for(let[,r,o,...a]of n("posts"))s.has(j(r))&&o.every(([,c])=>j(c)==="symbol")&&!a.some(c=>j(c[0])==="durable")&&t.set(j(r),o.length)}return t}function y_(i,t){let e=x_(),n=Ut("goal-answer"),s=Ut("goal-text"),r=(d,m="")=>{n.hidden=!1,n.className=m,n.textContent=d},o=async d=>{r("asking \u2026"),s.removeAttribute("aria-invalid");try{let[m]=await i.goal(d,y=>{y.error?r(Ae(y.error),"bad"):r(`goal ${m} ${y.values[0]}`,y.values[0]==="reached"?"good":"")});r(`goal ${m} accepted`)}catch(m){r(Ae(m),"bad"),d1(s,m)}};Ut("goal-form").addEventListener("submit",d=>{d.preventDefault(),o(s.value)}),Ut("cancel").addEventListener("click",async()=>{try{await i.request("coordinator","(cancel)")}catch(d){r(Ae(d),"bad")}});let a,l,c=ni(()=>{let d=t.until(i.moment??1/0);f1(a,a?g_(a,l,d):[])});t.onChange(c),i.follow("(plan ?n ?operations)",d=>{a=d.length?pt(d[0]):void 0,c()}),i.follow("(operation ?i ?operation ?state)",d=>{l=d[0],c()}),i.follow("(goal-state ?n ?state ?detail)",d=>{let m=d.map(pt).reduce((g,v)=>!g||v[1]>g[1]?v:g,void 0),y=Ut("goal-chip");if(y.hidden=!m,!m)return;let p=j(m[2]);y.textContent=`goal ${m[1]}: ${p}`,y.className=`chip ${p==="reached"?"good":p==="running"?"busy":"warn"}`,Ut("cancel").disabled=p!=="running"});let h=[],u=[],f=new Map;i.follow("(contract ?name ?form)",d=>f=p1(d)),i.follow("(believed ?fact)",d=>u=d.flatMap(m=>pt(m)[1].slice(1).map(j))),i.follow("(learned ?eyes ?name 1 ? ? ? ? ? ?)",d=>{h=d.map(m=>j(pt(m)[2])).filter(m=>m!==h1),e.setNames([...new Set(h)].slice(0,12))}),d_(s,d=>m_(d,{predicates:f,names:[...new Set([...h,...u])].sort()}))}var m1={connecting:"connecting",live:"live",lost:"no connection",refused:"no session"},hn=new il,os=new rl(hn),Gh=new cl(hn);f_();var g1=cp(hn);Z0(hn,os);op(os);var v_=Sg(hn),Hh=up(hn,Gh),S_=new Vh(hn);y_(hn,S_);Y0(hn);u_(hn,S_,Hh,fp(hn,Hh));lp(hn,Hh,()=>os.me);tp(hn,Hh,Gh,()=>os.me);Jd(hn,os);var M_=new el(hn);rp(hn,M_);qd(hn,M_);hn.onArm=v_.moveArm;hn.onHello=i=>{Ut("cell").textContent=i.cell,os.me=i.name,os.changed(),v_.setCell(i)};Gh.onChange(()=>{os.robot=Gh.server("robot")||os.robot,os.changed()});hn.onState=i=>{let t=Ut("state");t.textContent=m1[i],t.className=`chip ${i==="live"?"good":"bad"}`,document.body.dataset.state=i,g1(i)};hn.open();
